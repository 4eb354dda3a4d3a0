/// \file
/// What every test reads first; CMake compiles it once.
#pragma once

#include "tools/exact/exact.hpp"
#include "tools/program/precompiled.hpp"
#include "common/simd/choose.hpp"

#include "tests/catch.hpp"
