// Bullet in single precision, which most of its users have, for comparison in `morula bench`. It is a program of its
// own, since both libraries use the same names. It answers as `morula internal engine-worker` does.
#include <exception>

#include "engines/engine_worker.h"
#include "system/console.h"

int main() {
  try {
    morula::serveEngine(morula::questionStream(), morula::answerStream());
    return 0;
  } catch (const std::exception& error) {
    morula::tell(error.what(), false);
    return 70;
  }
}
