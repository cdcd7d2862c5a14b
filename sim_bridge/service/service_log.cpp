#include "sim_bridge/service/service_log.h"

#include <spdlog/details/null_mutex.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include <atomic>
#include <memory>
#include <nlohmann/json.hpp>

#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

std::atomic<std::uint64_t> warnings{0}, errors{0};

class CountingSink : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    if (message.level == spdlog::level::warn) ++warnings;
    if (message.level >= spdlog::level::err) ++errors;
  }
  void flush_() override {}
};

class JsonFormatter : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& out) override {
    spdlog::memory_buf_t time;
    time_.format(message, time);
    const auto level = spdlog::level::to_string_view(message.level);
    const nlohmann::ordered_json line{
        {"time", std::string(time.data(), time.size())},
        {"level", std::string(level.data(), level.size())},
        {"message", std::string(message.payload.data(), message.payload.size())}};
    // Bytes that are no UTF-8, of a file's name say, must not stop a message.
    const std::string text =
        line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
    out.append(text.data(), text.data() + text.size());
  }
  std::unique_ptr<spdlog::formatter> clone() const override {
    return std::make_unique<JsonFormatter>();
  }

 private:
  spdlog::pattern_formatter time_{"%Y-%m-%dT%H:%M:%S.%eZ", spdlog::pattern_time_type::utc, ""};
};

}  // namespace

void beginServiceLog(const std::string& option, const std::string& format) {
  if (format != "text" && format != "json") {
    throw InputError(option + ": '" + format + "' is not allowed; must be one of: text, json");
  }
  const auto logger = spdlog::default_logger();
  if (format == "json") logger->set_formatter(std::make_unique<JsonFormatter>());
  logger->sinks().push_back(std::make_shared<CountingSink>());
}

LogCounts logCounts() { return {warnings, errors}; }

}  // namespace seaway::bridge
