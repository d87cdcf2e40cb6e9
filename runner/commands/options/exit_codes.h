#pragma once
// The exit codes of the program, and the error of a wrong command line.
#include "system/exit_codes.h"
#include "system/usage_error.h"
