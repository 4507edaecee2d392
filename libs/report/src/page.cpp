#include "page.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "html.h"
#include "stretches.h"
#include "wardslam/building/rooms_of_map.h"
#include "wardslam/core/markup.h"
#include "wardslam/viewer/plan_picture.h"

namespace wardslam::report {
namespace {

using core::escapedForMarkup;
using Json = nlohmann::ordered_json;

std::string textOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Numbers of summary.json; files that were changed by hand hold anything.
std::optional<double> numberIn(const Json& json, const std::string& key) {
  if (!json.is_object()) return std::nullopt;
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

const Json& objectIn(const Json& json, const std::string& key) {
  static const Json kNone = Json::object();
  if (!json.is_object()) return kNone;
  const auto found = json.find(key);
  return found == json.end() || !found->is_object() ? kNone : *found;
}

std::string shown(const std::optional<double>& value, int decimals) {
  return value ? fixed(*value, decimals) : std::string("–");
}

std::string plain(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// JSON within <script>, which only "</" could end.
std::string forScript(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    c == '<' ? text += "\\u003c" : text += c;
  }
  return text;
}

class Page {
 public:
  explicit Page(const PageContent& content) : content_(content), run_(content.run), summary_(content.run.summary) {}

  [[nodiscard]] std::string assemble() const {
    const std::string library = textOf(content_.plotLibrary / "dygraph.min.js");
    const std::string plots = library.empty() || content_.plots.at("plots").empty() ? std::string() : plotFrames();
    const std::string body = figures() + section("map", "The map from above", map()) +
                             section("time", "Over time", plots) + section("lost", "Without a pose", stretches()) +
                             section("stages", "Time of each stage", stages()) + section("rooms", "Rooms", rooms()) +
                             section("zones", "Zones", zones()) + section("things", "Things", things()) +
                             section("pictures", "Pictures", content_.pictures) +
                             section("trouble", "Events", events()) + section("versions", "Versions", versions()) +
                             section("configuration", "Configuration", configuration());
    return pageHead(title(), library.empty() ? std::string() : textOf(content_.plotLibrary / "dygraph.min.css")) +
           heading() + remarks(content_.missing) + body + "<div id=\"tip\" hidden></div>\n" + script(library) +
           pageEnd();
  }

 private:
  [[nodiscard]] std::string time(double stamp_s) const { return timeText(stamp_s, run_.start_s(), run_.end_s()); }

  [[nodiscard]] std::string title() const {
    const std::string day = dayText(run_.start_s());
    return day.empty() ? "WardSLAM run" : "WardSLAM run of " + day;
  }

  [[nodiscard]] std::string heading() const {
    const std::string day = dayText(run_.start_s());
    return "<h1>WardSLAM run" + (day.empty() ? day : " of <span>" + day + "</span>") + "</h1>\n";
  }

  [[nodiscard]] std::string script(const std::string& library) const {
    return "<script type=\"application/json\" id=\"data\">" + forScript(content_.plots) + "</script>\n<script>\n" +
           library + "\n</script>\n<script>\n" + dataFile("report.js") + "</script>\n";
  }

  [[nodiscard]] std::string figures() const {
    std::vector<std::pair<std::string, std::string>> tiles;
    const auto add = [&](const char* name, const std::optional<double>& value, int decimals, const char* unit) {
      if (value && std::isfinite(*value)) tiles.emplace_back(name, fixed(*value, decimals) + unit);
    };
    const auto percent = [&](const char* key) {
      const auto share = numberIn(summary_, key);
      return share ? std::optional(100.0 * *share) : share;
    };
    add("frames", numberIn(summary_, "frames"), 0, "");
    add("of these with a pose", percent("coverage"), 1, " %");
    add("times lost", numberIn(summary_, "lost_events"), 0, "");
    add("keyframes", numberIn(summary_, "keyframes"), 0, "");
    add("loops closed", numberIn(summary_, "loops_closed"), 0, "");
    add("key points left out", percent("dynamic_keypoint_fraction"), 1, " %");
    if (content_.comparison) {
      const auto& errors = content_.comparison->ate.translation_m;
      add("error against truth, RMSE (ATE)", errors.rmse, 4, " m");
      add("error, largest", errors.max, 4, " m");
    }
    add("frames a second", numberIn(summary_, "fps"), 1, "");
    add("memory at most", numberIn(summary_, "peak_rss_mb"), 0, " MB");
    if (tiles.empty()) return {};
    std::string html = "<dl class=\"figures\">\n";
    for (const auto& [name, value] : tiles) html += "<div><dt>" + name + "</dt><dd>" + value + "</dd></div>\n";
    return html + "</dl>\n";
  }

  [[nodiscard]] std::string map() const {
    if (content_.plan.empty()) return {};
    std::string html = "<div class=\"plan\">" + content_.plan +
                       "</div>\n<p class=\"key\"><span class=\"way\"></span> way of the camera";
    if (content_.comparison) html += ", <span class=\"truth\"></span> true way, moved onto it";
    html += ".";
    if (run_.map) html += " Point at or tap a thing, room, zone or door for its name, class and times.";
    if (run_.unjoinedPieces > 0) {
      html += " Pieces that are not joined to the map are not drawn: " + std::to_string(run_.unjoinedPieces) + ".";
    }
    return html + "</p>\n";
  }

  [[nodiscard]] std::string plotFrames() const {
    std::string html;
    for (const auto& plot : content_.plots.at("plots")) {
      const std::string id = plot.at("id").get<std::string>();
      const std::string unit = plot.at("unit").get<std::string>();
      html += "<h3>" + plot.at("title").get<std::string>() + (unit.empty() ? "" : " [" + unit + "]") +
              "</h3><div class=\"legend\" id=\"legend-" + id + "\"></div><div class=\"plot\" id=\"plot-" + id +
              "\"></div>\n";
    }
    html +=
        "<p class=\"key\">Seconds since the run began. Stretches without a pose are shaded. Drag to look closer, "
        "double-click to see all.";
    const auto stride = content_.plots.at("stride").get<std::size_t>();
    if (stride > 1) html += " Of every " + std::to_string(stride) + " frames one is drawn.";
    return html + "</p>\n";
  }

  [[nodiscard]] std::string stretches() const {
    const auto found = stretchesWithoutPose(run_.frames);
    if (run_.frames.empty()) return {};
    if (found.empty()) return "<p>Every frame has a pose.</p>\n";
    const auto told = [](Ending ending) {
      switch (ending) {
        case Ending::Begins:
          return "tracking began";
        case Ending::Found:
          return "found again";
        case Ending::BegunAnew:
          return "begun anew as a piece of its own";
        case Ending::NotAnymore:
          return "the run ended";
      }
      return "";
    };
    std::vector<std::vector<std::string>> rows;
    for (const auto& stretch : found) {
      rows.push_back({time(stretch.from_s), time(stretch.to_s), std::to_string(stretch.frames), told(stretch.ending)});
    }
    return table({"from", "to", "frames", "then"}, rows);
  }

  [[nodiscard]] std::string stages() const {
    const Json& stages = objectIn(summary_, "stages");
    double longest_ms = 0.0;
    for (const auto& [name, times] : stages.items()) {
      longest_ms = std::max(longest_ms, numberIn(times, "p95_ms").value_or(0.0));
    }
    if (longest_ms <= 0.0) return {};
    // Stages last from tenths of a millisecond to seconds.
    const auto part = [&](double time_ms) { return 100.0 * std::sqrt(std::clamp(time_ms / longest_ms, 0.0, 1.0)); };
    std::string html =
        "<div class=\"wide\"><table class=\"stages\">\n<thead><tr><th>stage</th><th class=\"number\">calls</th>"
        "<th class=\"number\">median [ms]</th>"
        "<th class=\"number\">95 % [ms]</th><th class=\"bars\">median, and up to 95 % (root "
        "scale)</th></tr></thead>\n<tbody>\n";
    for (const auto& [name, times] : stages.items()) {
      const auto median_ms = numberIn(times, "median_ms");
      const auto p95_ms = numberIn(times, "p95_ms");
      html += "<tr><td>" + escapedForMarkup(name) + "</td>";
      for (const auto& text : {shown(numberIn(times, "calls"), 0), shown(median_ms, 2), shown(p95_ms, 2)}) {
        html += "<td class=\"number\">" + text + "</td>";
      }
      html += "<td class=\"bars\"><span class=\"bar\" style=\"width:" + fixed(part(p95_ms.value_or(0.0)), 1) +
              "%\"></span><span class=\"bar median\" style=\"width:" + fixed(part(median_ms.value_or(0.0)), 1) +
              "%\"></span></td></tr>\n";
    }
    return html + "</tbody></table></div>\n";
  }

  [[nodiscard]] std::string zones() const {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [name, stay] : objectIn(summary_, "zones").items()) {
      rows.push_back({name, shown(numberIn(stay, "time_s"), 1) + " s", shown(numberIn(stay, "distance_m"), 2) + " m",
                      shown(numberIn(stay, "entries"), 0)});
    }
    return rows.empty() ? std::string() : table({"zone", "time", "way", "entered"}, rows);
  }

  [[nodiscard]] std::string roomOf(const mapping::MapObject& object) const {
    return building::roomAt(run_.rooms, object.centroid_m);
  }

  [[nodiscard]] std::string rooms() const {
    const auto& rooms = run_.rooms;
    std::map<std::string, std::size_t> things;
    if (run_.map) {
      for (const auto& [id, object] : run_.map->objects) {
        if (object.state != mapping::ObjectState::Gone) ++things[roomOf(object)];
      }
    }
    std::map<int, std::string> leadsTo;
    for (const auto& door : rooms.doors) {
      for (const auto& [from, to] : {std::pair(door.room, door.other), std::pair(door.other, door.room)}) {
        leadsTo[from] += (leadsTo[from].empty() ? "" : ", ") + rooms.all.at(static_cast<std::size_t>(to - 1)).name;
      }
    }
    std::vector<std::vector<std::string>> rows;
    for (const auto& room : rooms.all) {
      rows.push_back({room.name, fixed(room.area_m2, 1) + " m²", std::to_string(things[room.name]), leadsTo[room.id]});
    }
    return rows.empty() ? std::string() : table({"room", "area", "things", "doors to"}, rows);
  }

  [[nodiscard]] std::string things() const {
    if (!run_.map || run_.map->objects.empty()) return {};
    std::vector<std::vector<std::string>> rows;
    for (const auto& [id, object] : run_.map->objects) {
      rows.push_back({viewer::tagOf(object, run_.map->labels), fixed(100.0 * object.probability, 0) + " %",
                      std::to_string(object.views), time(object.firstSeen_s), time(object.lastSeen_s), roomOf(object),
                      object.zone});
    }
    return "<details><summary>" + std::to_string(rows.size()) + " things</summary>\n" +
           table({"name", "sure", "images", "first seen", "last seen", "room", "zone"}, rows) + "</details>\n";
  }

  [[nodiscard]] std::string events() const {
    std::vector<std::vector<std::string>> rows;
    for (const char* key : {"events", "damaged_input"}) {
      for (const auto& [name, count] : objectIn(summary_, key).items()) rows.push_back({name, plain(count)});
    }
    return rows.empty() ? std::string() : table({"event", "times"}, rows);
  }

  [[nodiscard]] std::string versions() const {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [name, version] : objectIn(summary_, "versions").items()) rows.push_back({name, plain(version)});
    return rows.empty() ? std::string() : table({"of the run", "version"}, rows);
  }

  [[nodiscard]] std::string configuration() const {
    if (run_.configuration.empty()) return {};
    return "<details><summary>every option in effect</summary>\n<pre>" + escapedForMarkup(run_.configuration) +
           "</pre></details>\n";
  }

  const PageContent& content_;
  const RunRecord& run_;
  const Json& summary_;
};

}  // namespace

std::string assemblePage(const PageContent& content) { return Page(content).assemble(); }

}  // namespace wardslam::report
