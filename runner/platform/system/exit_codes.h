#pragma once
// The exit codes of the program.
namespace morula::cli {

enum ExitCode : int {
  fine = 0,
  differs = 1,     // a check differs
  usage = 2,       // the command line is wrong
  input = 3,       // a scenario or other input is wrong
  numerical = 4,   // the physics failed
  incomplete = 5,  // a study lacks runs
  file = 6,        // a file or database cannot be read or written
  bug = 70,        // an error of this program
  signalled = 128  // + the signal's number: 130, 143
};

}  // namespace morula::cli
