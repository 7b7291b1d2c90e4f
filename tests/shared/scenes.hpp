#pragma once

#include "client/lab/corpora/scene_makers.hpp"
#include "tests/shared/random.hpp"

namespace poolhall::testing {

using lab::break_scene;
using lab::random_scene;
using lab::scene_of;

}  // namespace poolhall::testing
