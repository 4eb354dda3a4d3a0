/// \file
/// What every test reads first; CMake compiles it once.
#pragma once

#include "common/program/precompiled.hpp"

#include "tests/catch.hpp"
