#pragma once
// What the program tells its caller by a number, and the error of a wrong command line.
#include "system/exit_codes.h"
#include "system/usage_error.h"
