#include "sim_bridge/selftest/verdict.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <string_view>
#include <vector>

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

constexpr int badInput = 2;

std::vector<fs::path> filesUnder(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    // The list by which the next run clears away what this one leaves.
    const bool isList = entry.path().extension() == ".unfinished";
    if (entry.is_regular_file() && !isList) files.push_back(entry.path());
  }
  return files;
}

/// Whether a run left the list by which the next one clears away what it drew.
bool hasListOfLeftovers(const fs::path& folder) {
  const fs::recursive_directory_iterator entries(folder);
  return std::any_of(begin(entries), end(entries), [](const fs::directory_entry& entry) {
    return entry.path().filename() == "summary.json.unfinished";
  });
}

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A table's or JSON's value that is not a number, such as `,nan,` or `: inf`.
bool hasNonNumber(std::string_view text) {
  const auto isPart = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  };
  for (const std::string_view word : {"nan", "inf", "NaN", "Infinity"}) {
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
      const std::size_t end = at + word.size();
      const bool begins = at == 0 || !isPart(text[at - 1]);
      if (begins && (end == text.size() || !isPart(text[end]))) return true;
    }
  }
  return false;
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string faultOfStatus(const ChildOutcome& outcome, Expected expected) {
  if (outcome.timedOut) return "it did not end";
  if (outcome.signal != 0) return "signal " + std::to_string(outcome.signal) + " ended it";
  const bool allowed = (outcome.status == 0 && expected != Expected::refuses) ||
                       (outcome.status == badInput && expected != Expected::works);
  if (allowed) return "";
  return "status " + std::to_string(outcome.status) + ": " + firstLine(outcome.err);
}

std::string faultOfRefusal(const ChildOutcome& outcome, const Expectation& expectation,
                           const fs::path& folder) {
  if (outcome.err.empty()) return "it refused without a message";
  static const std::regex place(R"(\.yaml:\d+)");
  if (expectation.namesFile && !std::regex_search(outcome.err, place)) {
    return "the message names no line of the scene: " + firstLine(outcome.err);
  }
  const auto left = filesUnder(folder);
  // A run that ends under way (a hull aground, say) keeps whole pictures and lists them for the
  // next.
  const bool underWay = !left.empty() && hasListOfLeftovers(folder);
  for (const fs::path& path : left) {
    const bool whole = path.filename().string().find(".part") == std::string::npos;
    if (!underWay || !whole) return "it refused and left " + path.filename().string();
  }
  return "";
}

std::string faultOfAnswer(const ChildOutcome& outcome, const fs::path& folder) {
  if (hasNonNumber(outcome.out)) return "standard output has values that are no numbers";
  for (const fs::path& file : filesUnder(folder)) {
    const bool isTable = file.extension() == ".csv" || file.extension() == ".json";
    if (isTable && hasNonNumber(textOf(file))) {
      return file.filename().string() + " has values that are no numbers";
    }
    if (fs::file_size(file) == 0) return file.filename().string() + " is empty";
  }
  return "";
}

}  // namespace

std::string faultOf(const ChildOutcome& outcome, const Expectation& expectation,
                    const fs::path& folder) {
  std::string fault = faultOfStatus(outcome, expectation.status);
  if (!fault.empty()) return fault;
  for (const char* word : {"terminate called", "what():", "runtime error", "Sanitizer"}) {
    if (outcome.err.find(word) != std::string::npos) return std::string("it says '") + word + "'";
  }
  fault = outcome.status == 0 ? faultOfAnswer(outcome, folder)
                              : faultOfRefusal(outcome, expectation, folder);
  if (!fault.empty() || expectation.says.empty()) return fault;
  const std::regex wanted(expectation.says);
  const bool said =
      std::regex_search(outcome.out, wanted) || std::regex_search(outcome.err, wanted);
  return said ? "" : "it does not say '" + expectation.says + "'";
}

}  // namespace seaway::bridge
