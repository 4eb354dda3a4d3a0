/// \file
/// What every test reads first; CMake compiles it once.
#pragma once

#include "common/simd/choose.hpp"
#include "tools/exact/exact.hpp"
#include "tools/program/precompiled.hpp"

#include "tests/catch.hpp"
