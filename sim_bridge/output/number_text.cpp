#include "sim_bridge/output/number_text.h"

#include <charconv>
#include <cmath>

namespace seaway::bridge {

namespace {

template <class T>
std::string shortest(T value) {
  if (std::isnan(value)) return "nan";  // to_chars would show the sign bit
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

std::string numberText(double value) { return shortest(value); }
std::string numberText(float value) { return shortest(value); }

}  // namespace seaway::bridge
