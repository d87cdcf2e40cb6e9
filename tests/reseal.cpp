// reseal FILE: renews the digests of a database's rows, for tests that change rows with other programs.
#include "reseal.h"

int main(int count, char** words) {
  if (count != 2) return 2;
  morula::test::reseal(words[1]);
  return 0;
}
