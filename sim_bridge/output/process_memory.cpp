#include "sim_bridge/output/process_memory.h"

#include <fstream>
#include <stdexcept>
#include <string>

namespace seaway::bridge {

std::size_t processMemory(std::initializer_list<std::string_view> lines) {
  std::ifstream file("/proc/self/status");
  std::size_t kibibytes = 0;
  bool isTold = false;
  for (std::string line; std::getline(file, line);) {
    for (const std::string_view wanted : lines) {
      if (!line.starts_with(wanted) || line[wanted.size()] != ':') continue;
      kibibytes += std::stoul(line.substr(wanted.size() + 1));
      isTold = isTold || wanted == *lines.begin();
    }
  }
  if (!isTold) {
    throw std::runtime_error("/proc/self/status tells no " + std::string(*lines.begin()));
  }
  return kibibytes * 1024;
}

}  // namespace seaway::bridge
