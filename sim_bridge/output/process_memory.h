#pragma once

#include <cstddef>
#include <initializer_list>
#include <string_view>

namespace seaway::bridge {

/// Sum of lines of /proc/self/status that tell sizes of this process, such as "VmHWM", bytes; each
/// is known to 4 KiB (proc(5)). Unlike getrusage's they have nothing of the process that started
/// it. Throws std::runtime_error where the first is not told.
std::size_t processMemory(std::initializer_list<std::string_view> lines);

}  // namespace seaway::bridge
