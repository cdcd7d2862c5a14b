#include "sim_bridge/service/metrics_service.h"

#include <httplib.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <condition_variable>
#include <cstring>
#include <thread>
#include <utility>

#include "render/png.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/output/stopwatch.h"
#include "sim_bridge/service/metrics_text.h"
#include "sim_bridge/service/service_status.h"
#include "sim_bridge/service/socket_address.h"
#include "sim_bridge/service/status_json.h"
#include "sim_bridge/service/status_page.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

constexpr std::size_t threads = 8;
constexpr std::size_t longestBody = 65536;
constexpr time_t longestRequest = 5;  // s, to be read and to be written

/// Asked for what there is not: 404.
struct NotFound : std::runtime_error {
  using std::runtime_error::runtime_error;
};

double timeIn(const httplib::Request& request, double now) {
  if (!request.has_param("t")) return now;
  const std::string text = request.get_param_value("t");
  double t = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), t);
  if (fault != std::errc{} || end != text.data() + text.size()) {
    throw InputError("t: '" + text + "' is not a number of seconds");
  }
  return t;
}

class MetricsEndpoint : public Endpoint {
 public:
  MetricsEndpoint(const SocketAddress& address, ServedSea& sea, const ServeClock& clock,
                  FrameMaker& frames, std::function<std::vector<std::string>()> descriptions)
      : frames_(frames),
        status_(sea, frames, clock, std::move(descriptions)),
        meter_(sea.meters().of("http")),
        address_(address) {
    addPages();
    bind();
  }
  ~MetricsEndpoint() override { stop(); }

  std::string description() const override {
    return "status and metrics on http://" + address_.text();
  }

  void start() override {
    serving_ = std::thread([this] { server_.listen_after_bind(); });
    // A server that does not run yet would not hear that it is to stop.
    while (!server_.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    noting_ = std::jthread([this](const std::stop_token& stop) { noteEachSecond(stop); });
  }

  void stop() override {
    if (!serving_.joinable()) return;
    noting_.request_stop();
    server_.stop();
    serving_.join();
    noting_.join();
  }

 private:
  using Request = httplib::Request;
  using Response = httplib::Response;

  void bind() {
    // Without SO_REUSEPORT, by which two services would share a port unawares.
    server_.set_socket_options([](int socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server_.set_payload_max_length(longestBody);
    server_.set_read_timeout(longestRequest);
    server_.set_write_timeout(longestRequest);
    server_.set_keep_alive_timeout(1);  // as long as a stop may have to wait for a silent client
    server_.new_task_queue = [] { return new httplib::ThreadPool(threads); };
    errno = 0;
    const int port = address_.port == 0 ? server_.bind_to_any_port(address_.host)
                     : server_.bind_to_port(address_.host, address_.port) ? int{address_.port}
                                                                          : -1;
    if (port < 0) {
      const std::string why = errno != 0 ? std::strerror(errno) : "the host is not known here";
      throw InputError("--metrics: cannot bind to " + address_.text() + ": " + why);
    }
    address_.port = static_cast<std::uint16_t>(port);
  }

  void addPages() {
    add("/", [this](const Request& request, Response& response) {
      const ServiceFigures figures = status_.read();
      response.set_content(statusPage(figures, cameraOf(request, figures)),
                           "text/html; charset=utf-8");
    });
    add("/status.json", [this](const Request&, Response& response) {
      response.set_content(statusJson(status_.read()), "application/json");
    });
    add("/metrics", [this](const Request&, Response& response) {
      response.set_content(metricsText(status_.read()), "text/plain; version=0.0.4; charset=utf-8");
    });
    add("/healthz",
        [](const Request&, Response& response) { response.set_content("ok\n", "text/plain"); });
    add(R"(/camera/(.+)\.png)",
        [this](const Request& request, Response& response) { drawPicture(request, response); });
    server_.set_error_handler([this](const Request&, Response& response) {
      if (response.body.empty()) {
        meter_.refused(response.status == 404   ? Refusal::notFound
                       : response.status == 413 ? Refusal::tooLarge
                                                : Refusal::malformed);
        response.set_content("not served: HTTP " + std::to_string(response.status) + "\n",
                             "text/plain");
      }
    });
  }

  template <class Answer>
  void add(const char* path, Answer answer) {
    server_.Get(path, [this, answer](const Request& request, Response& response) {
      const Stopwatch watch;
      const auto refuse = [&](int status, Refusal why, const char* text) {
        meter_.refused(why);
        response.status = status;
        response.set_content(std::string(text) + "\n", "text/plain; charset=utf-8");
      };
      try {
        answer(request, response);
        response.set_header("Cache-Control", "no-store");
        meter_.answered(0, 1e-3 * watch.milliseconds());
      } catch (const NotFound& fault) {
        refuse(404, Refusal::notFound, fault.what());
      } catch (const InputError& fault) {
        refuse(400, Refusal::badValue, fault.what());
      } catch (const std::exception& fault) {
        spdlog::error("http: {}: {}", request.path, fault.what());
        refuse(500, Refusal::failed, fault.what());
      }
    });
  }

  static std::string cameraOf(const Request& request, const ServiceFigures& figures) {
    const std::string asked = request.get_param_value("camera");
    if (asked.empty()) return figures.cameras.empty() ? "" : figures.cameras.front();
    requireCamera(asked, figures.cameras);
    return asked;
  }

  static void requireCamera(const std::string& name, const std::vector<std::string>& cameras) {
    if (std::find(cameras.begin(), cameras.end(), name) != cameras.end()) return;
    std::string all;
    for (const std::string& camera : cameras) all += (all.empty() ? "" : ", ") + camera;
    throw NotFound("no camera is called '" + name + "'; there is: " + (all.empty() ? "none" : all));
  }

  void drawPicture(const Request& request, Response& response) {
    const Stopwatch watch;
    FrameRequest wanted;
    wanted.camera = request.matches[1];
    requireCamera(wanted.camera, frames_.cameras());
    wanted.t = timeIn(request, status_.time());
    if (request.has_param("size")) wanted.size = parseSize(request.get_param_value("size"));
    const auto frame = frames_.draw(wanted);
    response.set_content(render::pngBytes(frame->colour), "image/png");
    meter_.frameSent(1e-3 * watch.milliseconds());
  }

  void noteEachSecond(const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any ended;
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
      ended.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
      status_.note();
    }
  }

  FrameMaker& frames_;
  ServiceStatus status_;
  Meter& meter_;
  SocketAddress address_;
  httplib::Server server_;
  std::thread serving_;
  std::jthread noting_;
};

}  // namespace

void addMetricsOptions(CLI::App& command, MetricsServiceOptions& options) {
  command
      .add_option("--metrics", options.address,
                  "[HOST:]PORT to serve a status page and Prometheus' metrics on over HTTP")
      ->group("Metrics");
}

std::unique_ptr<Endpoint> makeMetricsEndpoint(
    const MetricsServiceOptions& options, ServedSea& sea, const ServeClock& clock,
    FrameMaker& frames, std::function<std::vector<std::string>()> descriptions) {
  if (options.address.empty()) return nullptr;
  return std::make_unique<MetricsEndpoint>(parseSocketAddress("--metrics", options.address), sea,
                                           clock, frames, std::move(descriptions));
}

}  // namespace seaway::bridge
