// Bullet in single precision, which most of its users have: what `morula bench` asks beside the double one. A program
// of its own, since both libraries call what is in them by the same names. It answers what `morula engine-worker` does.
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
