// reseal FILE: takes the digests of a database's rows anew, for tests that change rows by other programs.
#include "reseal.h"

int main(int count, char** words) {
  if (count != 2) return 2;
  morula::test::reseal(words[1]);
  return 0;
}
