/// \file
/// What every recipe's program reads first; CMake compiles it once.
#pragma once

#include "common/math/vector.hpp"

#include <charconv>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>
