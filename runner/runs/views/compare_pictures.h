#pragma once
// Two picture files, held against each other as people see them.
#include <string>

#include "comparison/picture_difference.h"
#include "system/json.h"

namespace morula {

struct ComparedPictures {
  PictureDifference difference;
  std::string words;  // for people, with the threshold
  Image one, other;
};

/// Reads two PNG files of one size and compares them. Throws FileError and InputError.
ComparedPictures comparePictures(const std::string& one, const std::string& other);

/// Returns the difference for other programs, with the threshold and the verdict.
Json toJson(const PictureDifference& difference);

/// Both, and where they differ.
Drawing drawCompared(const ComparedPictures& compared);

}  // namespace morula
