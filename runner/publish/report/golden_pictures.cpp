#include "report/golden_pictures.h"

#include "page/html.h"
#include "page/page.h"
#include "report_data/words.h"

namespace morula {

std::string goldenPictures(const BesideGolden& beside, const std::string& name) {
  std::string notes;
  for (const std::string& note : beside.notes) notes += "<p class=\"note\">" + shown(note) + "</p>\n";
  if (!beside.images.unmatched.empty())
    notes += "<p class=\"note\">" + shown(beside.images.unmatched) + "</p>\n";
  if (beside.source == BesideGolden::Source::none)
    return "<div class=\"pictures\">" +
           htmlPicture("image/png", pngFile(beside.images.other), name + ": the organism as it is now",
                       "as it is now") +
           "</div>\n" + notes;
  std::string html =
      "<div class=\"compare\" data-first=\"accepted\" data-second=\"now\" data-names=\"as accepted | as it "
      "is "
      "now\"></div>\n<div class=\"pictures\">";
  const auto add = [&](const Image& image, const std::string& id, const std::string& what) {
    html += "<div data-picture=\"" + id + "\">" +
            htmlPicture("image/png", pngFile(image), name + ": " + what, what) + "</div>\n";
  };
  add(beside.images.one, "accepted", "as accepted");
  add(beside.images.other, "now", "as it is now");
  add(beside.images.distance, "distance", "how far it is from what is accepted");
  return html + "</div>\n" + notes;
}

}  // namespace morula
