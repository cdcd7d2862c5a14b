#include "sim_bridge/commands/selftest.h"

#include <spdlog/fmt/fmt.h>
#include <tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <iostream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <regex>

#include "sim_bridge/commands/options.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/output/stopwatch.h"
#include "sim_bridge/selftest/random_case.h"
#include "sim_bridge/selftest/yaml_json.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

/// Runs of a command that shrinking a failing scene may take.
constexpr int mostShrinkingRuns = 120;

struct Failure {
  HardCase hardCase;
  std::string fault;
};

struct AreaResult {
  std::size_t tried = 0, failed = 0;
};

/// What was tried so far; written to from many threads.
class Results {
 public:
  void add(const HardCase& hardCase, const std::string& fault) {
    const std::scoped_lock lock(mutex_);
    AreaResult& area = areas_[hardCase.area];
    ++area.tried;
    if (fault.empty()) return;
    ++area.failed;
    failures_.push_back({hardCase, fault});
  }
  const std::map<std::string, AreaResult>& areas() const { return areas_; }
  std::vector<Failure>& failures() { return failures_; }

 private:
  std::mutex mutex_;
  std::map<std::string, AreaResult> areas_;
  std::vector<Failure> failures_;
};

fs::path thisProgram() { return fs::read_symlink("/proc/self/exe"); }

fs::path configsFolder(const SelftestOptions& options) {
  if (!options.configs.empty()) return options.configs;
  const fs::path beside = "configs";
  if (fs::exists(beside / "hard_cases.yaml")) return beside;
  const fs::path installed = thisProgram().parent_path().parent_path() / "share" / "seaway";
  if (fs::exists(installed / "hard_cases.yaml")) return installed;
  throw InputError("hard_cases.yaml is neither in ./configs nor in " + installed.string() +
                   "; --configs FOLDER says where it is");
}

std::vector<fs::path> sceneFiles(const fs::path& configs) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(configs / "scenes")) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) throw InputError((configs / "scenes").string() + " has no scenes");
  return files;
}

ChildLimits limitsOf(const SelftestOptions& options) {
  ChildLimits limits{.time = std::chrono::milliseconds(static_cast<int>(1000.0 * options.limit))};
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they reserve terabytes
  limits.memoryBytes = std::size_t{8} << 30;
#endif
  return limits;
}

void tryCatalogue(const HardCases& catalogue, const SelftestOptions& options, Results& results) {
  const std::regex wanted(options.only);
  Progress progress("hard cases", catalogue.cases.size());
  std::atomic<std::size_t> done{0};
  std::mutex bar;
  tbb::parallel_for(std::size_t{0}, catalogue.cases.size(), [&](std::size_t i) {
    const HardCase& hardCase = catalogue.cases[i];
    if (!std::regex_search(hardCase.name, wanted)) return;
    results.add(hardCase, tryCase(hardCase, thisProgram(), limitsOf(options)));
    const std::scoped_lock lock(bar);
    progress.update(++done);
  });
}

/// Random cases until their number or their time is up.
void tryRandom(const std::vector<fs::path>& examples, const SelftestOptions& options,
               Results& results) {
  const Stopwatch watch;
  const bool endless = options.hours > 0.0;
  const double limit = endless ? 3600.0 * options.hours : options.seconds;
  const auto count = static_cast<std::size_t>(options.count);
  const std::size_t together = 64;
  Progress progress("random scenes", endless ? 0 : count);
  for (std::size_t first = 0; endless || first < count; first += together) {
    std::atomic<bool> late{false};
    const std::size_t last = endless ? first + together : std::min(count, first + together);
    tbb::parallel_for(first, last, [&](std::size_t i) {
      late = late || (limit > 0.0 && watch.milliseconds() > 1000.0 * limit);
      if (late) return;
      const auto seed = static_cast<std::uint64_t>(options.seed) + i;
      const HardCase hardCase = randomCase(seed, examples);
      results.add(hardCase, tryCase(hardCase, thisProgram(), limitsOf(options)));
    });
    progress.update(last);
    if (late) return;
  }
}

/// Makes failing scenes small and writes them down; names of the files.
std::vector<std::string> keep(std::vector<Failure>& failures, const SelftestOptions& options) {
  std::vector<std::string> files;
  if (options.out.empty()) return files;
  for (Failure& failure : failures) {
    const auto fails = [&](const HardCase& candidate) {
      return tryCase(candidate, thisProgram(), limitsOf(options)) == failure.fault;
    };
    failure.hardCase = shrunk(failure.hardCase, fails, mostShrinkingRuns);
    std::string name = failure.hardCase.name;
    std::replace_if(
        name.begin(), name.end(),
        [](char c) { return !std::isalnum(static_cast<unsigned char>(c)) && c != '-'; }, '_');
    const fs::path path = fs::path(options.out) / (name + ".yaml");
    AtomicFile file(path);
    file.stream() << "# " << failure.fault << "\n# seaway";
    for (const std::string& word : failure.hardCase.arguments) file.stream() << ' ' << word;
    file.stream() << '\n';
    if (!failure.hardCase.scene.is_null()) {
      file.stream() << yamlFromJson(failure.hardCase.scene);
    }
    file.commit();
    files.push_back(path.string());
  }
  return files;
}

void writeList(const HardCases& catalogue, std::ostream& out) {
  std::map<std::string, std::pair<std::size_t, std::vector<std::string>>> areas;
  for (const HardCase& each : catalogue.cases) ++areas[each.area].first;
  for (const HardTests& each : catalogue.tests) areas[each.area].second.push_back(each.covers);
  out << "| area | commands | tests |\n|---|---|---|\n";
  for (const auto& [area, entry] : areas) {
    std::string covers;
    for (const std::string& each : entry.second) covers += (covers.empty() ? "" : "; ") + each;
    out << fmt::format("| {} | {} | {} |\n", area, entry.first, covers);
  }
}

void writeReport(Results& results, const std::vector<std::string>& kept, const Stopwatch& watch,
                 bool json, std::ostream& out) {
  nlohmann::ordered_json areas = nlohmann::ordered_json::object(),
                         failures = nlohmann::ordered_json::array();
  std::size_t tried = 0;
  for (const auto& [area, result] : results.areas()) {
    areas[area] = {{"tried", result.tried}, {"failed", result.failed}};
    tried += result.tried;
  }
  for (std::size_t i = 0; i < results.failures().size(); ++i) {
    const Failure& failure = results.failures()[i];
    failures.push_back({{"name", failure.hardCase.name},
                        {"property", failure.hardCase.property},
                        {"fault", failure.fault}});
    if (i < kept.size()) failures.back()["file"] = kept[i];
  }
  if (json) {
    out << nlohmann::ordered_json{{"tried", tried},
                                  {"areas", areas},
                                  {"failures", failures},
                                  {"seconds", watch.milliseconds() / 1000.0}}
               .dump(2)
        << '\n';
    return;
  }
  for (const auto& failure : failures) {
    out << fmt::format(
        "FAILED {}: {} ({}){}\n", failure["name"].get<std::string>(),
        failure["fault"].get<std::string>(), failure["property"].get<std::string>(),
        failure.contains("file") ? ", kept as " + failure["file"].get<std::string>() : "");
  }
  for (const auto& [area, result] : results.areas()) {
    out << fmt::format("{:<16} {:>6} tried {:>4} failed\n", area, result.tried, result.failed);
  }
  out << fmt::format("{} cases in {:.0f} s, {} failed\n", tried, watch.milliseconds() / 1000.0,
                     failures.size());
}

}  // namespace

int runSelftest(const SelftestOptions& options, std::ostream& out) {
  requireInRange("--hours", options.hours, Range::within(0.0, 1e5), "h");
  requireInRange("--count", static_cast<double>(options.count), Range::within(0.0, 1e9), "");
  requireInRange("--seconds", options.seconds, Range::within(0.0, 1e9), "s");
  requireInRange("--limit", options.limit, Range::within(0.1, 1e5), "s");
  requireInRange("--seed", static_cast<double>(options.seed), Range::atLeast(0.0), "");
  try {
    std::regex{options.only};
  } catch (const std::regex_error&) {
    throw InputError("--only: '" + options.only + "' is not a regular expression");
  }
  const fs::path configs = configsFolder(options);
  const HardCases catalogue = readHardCases(configs / "hard_cases.yaml");
  if (options.list) {
    writeList(catalogue, out);
    return 0;
  }
  if (!options.out.empty()) requireWritableFolder(options.out);
  const Stopwatch watch;
  Results results;
  tryCatalogue(catalogue, options, results);
  tryRandom(sceneFiles(configs), options, results);
  const std::vector<std::string> kept = keep(results.failures(), options);
  writeReport(results, kept, watch, options.json, out);
  return results.failures().empty() ? 0 : 1;
}

void addSelftestCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand(
      "selftest",
      "Try hard cases and random scenes on this machine: no crash, no hang, no silence");
  auto options = std::make_shared<SelftestOptions>();
  command->add_option("--configs", options->configs,
                      "folder with hard_cases.yaml and scenes/ (default: ./configs, or the one "
                      "that is installed)");
  command->add_option("--count", options->count, "random cases to try (default 100)");
  command->add_option("--hours", options->hours, "go on with random cases for so many hours");
  command->add_option("--seconds", options->seconds,
                      "begin no more random cases after so many seconds");
  command->add_option("--limit", options->limit, "seconds that a case may take (default 60)");
  command->add_option("--seed", options->seed, "of the first random case (default 1)");
  command->add_option("--only", options->only, "hard cases whose names match this expression");
  command
      ->add_option("--out", options->out,
                   "folder for scenes that fail, made as small as they can be")
      ->check(mustBeNamed);
  command->add_flag("--list", options->list, "print what the catalogue holds, as a table");
  command->add_flag("--json", options->json, "machine-readable");
  command->footer("Example:\n  seaway selftest --count 200 --out out/selftest");
  command->callback([=, &chosen] { chosen = [=] { return runSelftest(*options, std::cout); }; });
}

}  // namespace seaway::bridge
