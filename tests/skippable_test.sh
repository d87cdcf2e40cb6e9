#!/bin/sh
# Tests skippable.sh: exit codes pass through; 77 becomes 1 with CI set, and stays 77 without.
here=$(dirname "$0")
answers() { # answers CODE [CI]: the exit code of skippable.sh for a test that ends with CODE
  env -u CI ${2:+CI="$2"} "$here/skippable.sh" sh -c "exit $1" >/dev/null
  echo $?
}
expect() { # expect WHAT GIVEN WANTED
  if [ "$2" != "$3" ]; then echo "FAILED: $1 gives $2 in place of $3" && failed=1; fi
}
failed=0
expect "a skipped test" "$(answers 77)" 77
expect "a skipped test with CI" "$(answers 77 true)" 1
expect "a skipped test with CI empty" "$(answers 77 '')" 77
expect "a passed test with CI" "$(answers 0 true)" 0
expect "a failed test with CI" "$(answers 3 true)" 3
exit $failed
