#pragma once

#include "client/lab/random.hpp"

namespace poolhall::testing {

using lab::Random;

}  // namespace poolhall::testing
