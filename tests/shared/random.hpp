#pragma once

#include "client/lab/corpora/random.hpp"

namespace poolhall::testing {

using lab::Random;

}  // namespace poolhall::testing
