#pragma once

#include <cstddef>

namespace seaway::test_support {

/// Calls of operator new so far in this program: link allocation_counter.cpp to count them.
std::size_t allocationCount();

}  // namespace seaway::test_support
