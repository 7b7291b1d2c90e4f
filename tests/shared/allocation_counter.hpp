#pragma once

namespace poolhall::testing {

/// How often this program has called operator new. Links in a replacement of operator new, in a
/// file of its own because compilers complain where they see it next to its calls.
[[nodiscard]] long allocations();

}  // namespace poolhall::testing
