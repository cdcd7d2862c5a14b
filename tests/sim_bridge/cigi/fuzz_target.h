#pragma once

#include <cstddef>
#include <cstdint>

/// What libFuzzer calls: an input is a byte (its lowest bit: asynchronous) and then datagrams, each
/// behind its length in two bytes, that one session gets. Returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
