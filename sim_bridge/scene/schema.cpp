#include "sim_bridge/scene/schema.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>

#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string withUnit(const std::string& text, const std::string& unit) {
  return unit.empty() || unit == "1" ? text : text + " " + unit;
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all;
}

// YAML's numbers: those of from_chars, a leading plus, and .inf and .nan.
std::optional<double> parseNumber(std::string_view text) {
  if (text == ".inf" || text == ".Inf" || text == ".INF" || text == "inf") return infinity;
  if (text == "-.inf" || text == "-.Inf" || text == "-.INF" || text == "-inf") return -infinity;
  if (text == ".nan" || text == ".NaN" || text == ".NAN") return std::nan("");
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

bool Range::holds(double value) const {
  if (std::isnan(value) || value == -infinity) return false;
  if (value == infinity) return infinityAllowed;
  return (leastIncluded ? value >= least : value > least) &&
         (mostIncluded ? value <= most : value < most);
}

std::string Range::text() const {
  std::string text;
  if (least == -infinity && most == infinity) {
    text = "finite";
  } else if (most == infinity) {
    text = (leastIncluded ? "≥ " : "> ") + numberText(least);
  } else if (least == -infinity) {
    text = (mostIncluded ? "≤ " : "< ") + numberText(most);
  } else {
    text = (leastIncluded ? "[" : "(") + numberText(least) + ", " + numberText(most) +
           (mostIncluded ? "]" : ")");
  }
  return infinityAllowed ? text + " or inf" : text;
}

std::string Range::sentence() const {
  const std::string range = text();
  return (range[0] == '[' || range[0] == '(' ? "must be in " : "must be ") + range;
}

double readNumber(const YamlValue& value, const Range& range, const std::string& unit) {
  const std::string allowed = withUnit(range.sentence(), unit);
  if (value.kind != YamlValue::Kind::scalar) {
    value.fail(value.shown() + " is not a number; " + allowed);
  }
  const std::optional<double> number = parseNumber(value.scalar);
  if (!number) value.fail("'" + value.scalar + "' is not a number; " + allowed);
  if (!range.holds(*number)) value.fail(value.scalar + " is not allowed; " + allowed);
  return *number;
}

std::int64_t readInteger(const YamlValue& value, std::int64_t least, std::int64_t most) {
  const std::string allowed =
      "must be a whole number in [" + std::to_string(least) + ", " + std::to_string(most) + "]";
  const std::string& text = value.scalar;
  std::int64_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (value.kind != YamlValue::Kind::scalar || fault != std::errc{} ||
      end != text.data() + text.size() || number < least || number > most) {
    value.fail(value.shown() + " is not allowed; " + allowed);
  }
  return number;
}

std::string readText(const YamlValue& value) {
  if (value.kind != YamlValue::Kind::scalar || value.scalar.empty()) {
    value.fail(value.shown() + " is not allowed; must be text");
  }
  return value.scalar;
}

std::string readName(const YamlValue& value) {
  const std::string text = readText(value);
  const bool plain = std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return (c < 0x80 && std::isalnum(c)) || c == '_' || c == '-';
  });
  if (!plain) value.fail("'" + text + "' is not allowed; must be of letters, digits, _ and -");
  return text;
}

const YamlValue& requireKind(const YamlValue& value, YamlValue::Kind kind, const char* wanted) {
  if (value.kind != kind) value.fail(value.shown() + " is not allowed; must be " + wanted);
  return value;
}

void failUnknownKey(const YamlValue& value, const std::vector<std::string>& known) {
  const std::string nearest = nearestName(value.name, known);
  value.fail("unknown key" +
             (nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?") +
             (known.empty() ? " (no keys are allowed here)" : " (known: " + joined(known) + ")"));
}

void failChoice(const YamlValue& value, const std::vector<std::string>& choices) {
  value.fail(value.shown() + " is not allowed; must be one of: " + joined(choices));
}

std::string nearestName(const std::string& word, const std::vector<std::string>& candidates) {
  std::string nearest;
  std::size_t least = std::max<std::size_t>(2, word.size() / 2) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(word, candidate);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

void requireInRange(const std::string& name, double value, const Range& range,
                    const std::string& unit) {
  if (range.holds(value)) return;
  throw InputError(name + ": " + numberText(value) + " is not allowed; " +
                   withUnit(range.sentence(), unit));
}

}  // namespace seaway::bridge
