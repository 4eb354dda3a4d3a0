/// \file
/// What every recipe's program reads first; CMake compiles it once.
#pragma once

#include "common/math/rational.hpp"
#include "common/math/vector.hpp"

#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>
