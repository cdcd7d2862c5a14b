#include "sim_bridge/service/status_page.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "sim_bridge/report/html_page.h"
#include "sim_bridge/service/status_json.h"

namespace seaway::bridge {
namespace {

constexpr const char* style = R"(
:root{color-scheme:light dark;--ink:#1b2a36;--soft:#5b6b78;--line:#d8e0e6;--paper:#f5f8fa;--card:#fff;--on:#11734b;--bad:#b3261e}
@media(prefers-color-scheme:dark){:root{--ink:#e3ebf0;--soft:#93a4b1;--line:#2c3a45;--paper:#10181e;--card:#17222a;--on:#5fd39f;--bad:#ff8a80}}
*{box-sizing:border-box}body{margin:0;background:var(--paper);color:var(--ink);font:14px/1.45 system-ui,sans-serif}
main{max-width:1180px;margin:0 auto;padding:20px}
header{display:flex;flex-wrap:wrap;gap:4px 18px;align-items:baseline;margin-bottom:14px}
h1{font-size:22px;margin:0}h2{font-size:12px;letter-spacing:.06em;text-transform:uppercase;color:var(--soft);margin:0 0 8px}
.soft{color:var(--soft)}.grid{display:grid;grid-template-columns:repeat(auto-fit,minmax(330px,1fr));gap:14px}
section{background:var(--card);border:1px solid var(--line);border-radius:8px;padding:14px;overflow-x:auto}
.wide{grid-column:1/-1}.view{padding:0;overflow:hidden;display:flex;flex-direction:column;background:#0b1116}
.view img{width:100%;aspect-ratio:16/9;object-fit:contain;display:block}
nav{display:flex;flex-wrap:wrap;gap:12px;padding:8px 14px;background:var(--card)}nav a{color:inherit}nav a.here{font-weight:600;text-decoration:none}
table{border-collapse:collapse;width:100%}th{text-align:right;font-weight:500;color:var(--soft)}
td{text-align:right;font-variant-numeric:tabular-nums}th,td{padding:3px 8px;border-bottom:1px solid var(--line);white-space:nowrap}
tr:last-child td{border-bottom:0}th:first-child,td:first-child{text-align:left;padding-left:0}td.text,th.text{text-align:left;white-space:normal}
.on{color:var(--on);font-weight:600}.bad{color:var(--bad);font-weight:600}
)";

// The page's one text is what the server makes: a new one takes the place of the old, but for the
// picture, which stays until the next has come.
constexpr const char* script = R"(
setInterval(async()=>{try{
const page=new DOMParser().parseFromString(await (await fetch(location.href)).text(),'text/html');
const next=page.querySelector('main'),old=document.querySelector('main img'),img=next.querySelector('img');
if(old&&img){const ready=new Image();ready.src=img.src;await ready.decode().catch(()=>{})}
document.querySelector('main').replaceWith(next);document.body.classList.remove('gone')
}catch(e){document.querySelector('#state').textContent='does not answer';}},2000)
)";

std::string number(const std::optional<double>& value, const char* format, const char* unit) {
  if (!value) return "–";
  return fmt::format(fmt::runtime(format), *value) + unit;
}

std::string seconds(double value) {
  if (!(value > 0.0)) return "–";
  if (value < 1e-3) return fmt::format("{:.3g} µs", value * 1e6);
  if (value < 1.0) return fmt::format("{:.3g} ms", value * 1e3);
  return fmt::format("{:.3g} s", value);
}

std::string bytes(std::size_t value) {
  if (value == 0) return "–";
  const double mega = static_cast<double>(value) / 1e6;
  return mega < 0.1 ? fmt::format("{:.1f} kB", mega * 1e3) : fmt::format("{:.1f} MB", mega);
}

std::string duration(double value) {
  const auto all = static_cast<long long>(value);
  const long long hours = all / 3600;
  return hours > 0 ? fmt::format("{} h {:02} min", hours, all / 60 % 60)
                   : fmt::format("{} min {:02} s", all / 60, all % 60);
}

std::string query(const std::string& camera, double t) {
  std::string name;
  for (const char c : camera) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_';
    name += plain ? std::string(1, c)
                  : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return fmt::format("/camera/{}.png?t={:.3f}&amp;size=960x540", name, t);
}

std::string seaSection(const ServiceFigures& figures) {
  const auto row = [](const char* what, const SeaStateFigures& state) {
    return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>", what,
                       number(state.significantWaveHeight, "{:.2f}", " m"),
                       number(state.peakPeriod, "{:.1f}", " s"),
                       number(state.from_deg, "{:.0f}", "°"));
  };
  return "<section id=\"sea\"><h2>Sea state</h2><table><tr><th></th><th>H<sub>m0</sub></th>"
         "<th>T<sub>p</sub></th><th>from</th></tr>" +
         row("asked", figures.asked) + row("realised", figures.realised) + "</table></section>";
}

std::string timeSection(const ServiceFigures& figures) {
  const auto row = [](const char* what, const std::string& value) {
    return fmt::format("<tr><td>{}</td><td>{}</td></tr>", what, value);
  };
  const auto span = figures.wakeSpan ? fmt::format("{:.1f} – {:.1f} s", figures.wakeSpan->first,
                                                   figures.wakeSpan->second)
                                     : std::string("–");
  return "<section id=\"time\"><h2>Time and wakes</h2><table>" +
         row("time since the epoch", fmt::format("{:.2f} s", figures.time)) +
         row(figures.clock == "host" ? "asked for by hosts, × real time" : "own clock, × real time",
             fmt::format("{:.2f}", figures.realTimeFactor)) +
         row("wakes running", std::to_string(figures.wakes.running)) + row("wakes cover", span) +
         row("their memory", bytes(figures.wakes.memoryBytes)) + "</table></section>";
}

std::string loadSection(const ServiceFigures& figures) {
  std::string rows;
  for (const EndpointLoad& load : figures.endpoints) {
    std::uint64_t refused = 0;
    for (const std::uint64_t count : load.total.refusals) refused += count;
    rows += fmt::format(
        "<tr><td>{}</td><td>{:.1f}</td><td>{:.0f}</td><td>{}</td><td>{}</td><td>{:.1f}</td>"
        "<td>{}</td><td{}>{}</td></tr>",
        htmlEscaped(load.name), load.requestsPerSecond, load.pointsPerSecond, seconds(load.median),
        seconds(load.percentile99), load.framesPerSecond, load.total.requests.total(),
        refused > 0 ? " class=\"bad\"" : "", refused);
  }
  return "<section id=\"load\" class=\"wide\"><h2>Load, last ten "
         "seconds</h2><table><tr><th>endpoint"
         "</th><th>requests/s</th><th>points/s</th><th>p50</th><th>p99</th><th>pictures/s</th>"
         "<th>requests in all</th><th>refused in all</th></tr>" +
         rows + "</table></section>";
}

std::string effectsSection(const ServiceFigures& figures) {
  std::string rows;
  for (const EffectReport& effect : figures.effects) {
    const auto name = effectName(effect.effect);
    rows += fmt::format(
        "<tr><td>{}</td><td class=\"text {}\">{}</td><td>{}</td><td>{}</td>"
        "<td class=\"text soft\">{}</td></tr>",
        name, effect.state == EffectState::on ? "on" : "soft", effectStateName(effect.state),
        bytes(effect.memoryBytes), seconds(effect.costMicroseconds * 1e-6),
        htmlEscaped(effect.reason));
  }
  return "<section id=\"effects\" class=\"wide\"><h2>Effects in the last picture</h2><table><tr>"
         "<th>effect</th><th class=\"text\">state</th><th>memory</th><th>cost</th>"
         "<th class=\"text\">why</th></tr>" +
         rows + "</table></section>";
}

std::string vesselsSection(const ServiceFigures& figures) {
  if (figures.vessels.empty()) return "";
  std::string rows;
  for (const VesselFigures& vessel : figures.vessels) {
    rows += fmt::format(
        "<tr><td>{}</td><td class=\"text\">{}</td><td>{:.5f}°</td><td>{:.5f}°</td><td>{:.0f}°</td>"
        "<td>{:.2f} m</td></tr>",
        htmlEscaped(vessel.name),
        vessel.hosted      ? "a host"
        : vessel.outOfTime ? "itself, at another time"
        : vessel.free      ? "itself"
                           : "its course",
        vessel.latitude_deg, vessel.longitude_deg, vessel.heading_deg, vessel.height);
  }
  return "<section id=\"vessels\" class=\"wide\"><h2>Vessels</h2><table><tr><th>vessel</th><th "
         "class=\"text\">sailed by</th><th>latitude</th><th>longitude</th><th>heading</th>"
         "<th>height</th></tr>" +
         rows + "</table></section>";
}

std::string endpointsSection(const ServiceFigures& figures) {
  std::string rows;
  for (const std::string& each : figures.descriptions) {
    rows += "<tr><td>" + htmlEscaped(each) + "</td></tr>";
  }
  return "<section id=\"endpoints\"><h2>Endpoints</h2><table>" + rows +
         "</table><p><a href=\"/status.json\">status.json</a> · <a href=\"/metrics\">metrics</a> "
         "· " +
         fmt::format("<span class=\"{}\">{} errors, {} warnings logged</span></p></section>",
                     figures.errors > 0 ? "bad" : "soft", figures.errors, figures.warnings);
}

std::string viewSection(const ServiceFigures& figures, const std::string& camera) {
  if (camera.empty()) return "";
  std::string links;
  for (const std::string& each : figures.cameras) {
    links += fmt::format("<a href=\"/?camera={0}\"{1}>{0}</a>", htmlEscaped(each),
                         each == camera ? " class=\"here\"" : "");
  }
  return fmt::format(
      "<section class=\"view wide\"><img alt=\"camera {}\" src=\"{}\"><nav>{}</nav></section>",
      htmlEscaped(camera), query(camera, figures.time), links);
}

}  // namespace

std::string statusPage(const ServiceFigures& figures, const std::string& camera) {
  return std::string(
             "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\">"
             "<meta name=\"viewport\" content=\"width=device-width\">"
             "<link rel=\"icon\" href=\"data:,\"><title>Seaway</title><style>") +
         style + "</style></head><body><main><header><h1>Seaway</h1><span>" +
         htmlEscaped(figures.scene) + "</span><span class=\"soft\">version " + figures.version +
         "</span><span class=\"soft\">up " + duration(figures.uptime) +
         "</span><span id=\"state\" class=\"on\">serving</span></header><div class=\"grid\">" +
         viewSection(figures, camera) + seaSection(figures) + timeSection(figures) +
         endpointsSection(figures) + loadSection(figures) + vesselsSection(figures) +
         effectsSection(figures) + "</div></main><script>" + script + "</script></body></html>\n";
}

}  // namespace seaway::bridge
