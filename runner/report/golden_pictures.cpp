#include "report/golden_pictures.h"

#include "page/html.h"
#include "page/page.h"
#include "report/words.h"

namespace morula {

std::string goldenPictures(const BesideGolden& beside, const std::string& name, bool swiped) {
  std::string notes;
  for (const std::string& note : beside.notes) notes += "<p class=\"note\">" + shown(note) + "</p>\n";
  if (!beside.images.unmatched.empty())
    notes += "<p class=\"note\">" + shown(beside.images.unmatched) + "</p>\n";
  if (beside.source == BesideGolden::Source::none)
    return "<div class=\"pictures\">" +
           htmlPicture("image/png", pngFile(beside.images.other), name + ": the organism as it is now",
                       "as it is now") +
           "</div>\n" + notes;
  std::string html;
  if (swiped)
    html += "<div id=\"compare\" data-first=\"as-accepted\" data-second=\"as-it-is\" data-names=\"" +
            htmlText(shown("as accepted | as it is now")) + "\"></div>\n";
  html += "<div class=\"pictures\">";
  const auto add = [&](const Image& image, const std::string& id, const std::string& what) {
    const std::string picture = htmlPicture("image/png", pngFile(image), name + ": " + what, what);
    html += swiped && !id.empty() ? "<div id=\"" + id + "\">" + picture + "</div>\n" : picture;
  };
  add(beside.images.one, "as-accepted", "as accepted");
  add(beside.images.other, "as-it-is", "as it is now");
  add(beside.images.distance, "", "how far it is from what is accepted");
  return html + "</div>\n" + notes;
}

}  // namespace morula
