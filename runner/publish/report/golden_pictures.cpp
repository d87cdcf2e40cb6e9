#include "report/golden_pictures.h"

#include "report_data/words.h"

namespace morula {

Document goldenPictures(const BesideGolden& beside, const std::string& name) {
  Document all, pictures;
  const ComparisonImages& images = beside.images;
  if (beside.source == BesideGolden::Source::none) {
    pictures.add(pngPicture(images.other, name + ": the organism as it is now", "as it is now"));
  } else {
    all.add(Swipe{"accepted", "now", "as accepted | as it is now"});
    const auto add = [&](const Image& image, const std::string& id, const std::string& what) {
      pictures.add(pngPicture(image, name + ": " + what, what, id));
    };
    add(images.one, "accepted", "as accepted");
    add(images.other, "now", "as it is now");
    add(images.distance, "distance", "how far it is from what is accepted");
  }
  all.add(Group{Group::Kind::pictures, "", std::move(pictures)});
  for (const std::string& note : beside.notes) all.note(note);
  if (!images.unmatched.empty()) all.note(images.unmatched);
  return all;
}

}  // namespace morula
