#pragma once
// The organism's shape at one time, stored until its sequence of pictures is drawn.
#include <string>

#include "organism/organism.h"

namespace morula {

/// Writes the part that changes from one picture of a sequence to the next: cells and caption.
std::string frameBytes(const OrganismPicture& picture);

/// Restores a picture; `blank` has what all pictures of the sequence share. Throws InputError for bytes of no frame.
OrganismPicture pictureFrom(const std::string& bytes, OrganismPicture blank);

}  // namespace morula
