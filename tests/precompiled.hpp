/// \file
/// What every test reads first; CMake compiles it once.
#pragma once

#include "common/exact/exact.hpp"
#include "common/program/precompiled.hpp"
#include "common/simd/choose.hpp"

#include "tests/catch.hpp"
