#include "wardslam/viewer/graph_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "wardslam/core/markup.h"
#include "wardslam/knowledge/knowledge_graph.h"

namespace wardslam::viewer {
namespace {

// All lengths in px of the picture.
constexpr double kMargin = 30;
constexpr double kLeft = 70;  ///< Of the left column; room for lines beside it.
constexpr double kLeftWidth = 250;
constexpr double kRight = 700;  ///< Of the right column.
constexpr double kRightWidth = 290;
constexpr double kPillHeight = 24;
constexpr double kTitleHeight = 26;
constexpr double kGap = 6;
constexpr double kTagHeight = 15;
constexpr double kLetter = 6.1;  ///< Width of a letter of a tag.

constexpr std::array<const char*, 8> kColours = {"#c2410c", "#1d4ed8", "#047857", "#a21caf",
                                                 "#b45309", "#0e7490", "#be123c", "#4d7c0f"};

std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return core::escapedForMarkup(name);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// A frame (set) or pill (entity). Lines end at its title.
struct Box {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
  double titleHeight = 0;
  bool isSet = false;

  [[nodiscard]] double middle() const { return y + titleHeight / 2; }
};

class Drawing {
 public:
  explicit Drawing(const knowledge::KnowledgeGraph& graph) : graph_(graph) {
    for (const knowledge::Fact& fact : graph.facts()) {
      colours_.emplace(fact.tail, kColours[colours_.size() % kColours.size()]);
    }
  }

  std::string draw() {
    double left = place("moving", kLeft, kMargin + 30, kLeftWidth) + 3 * kGap;
    left = place("static", kLeft, left, kLeftWidth);
    const double right = place("movable", kRight, kMargin + 30, kRightWidth);
    for (const knowledge::Fact& fact : graph_.facts()) line(fact);
    std::ostringstream svg;
    svg << std::fixed << std::setprecision(1);
    const double width = kRight + kRightWidth + kMargin;
    const double height = std::max(left, right) + kMargin;
    svg << R"(<svg xmlns="http://www.w3.org/2000/svg" width=")" << width << R"(" height=")" << height
        << R"(" font-family="sans-serif" font-size="13"><rect width="100%" height="100%" fill="white"/>)"
        << "\n"
        << caption() << lines_.str() << boxes_.str() << tags_.str() << "</svg>\n";
    return svg.str();
  }

 private:
  [[nodiscard]] bool isSet(const std::string& name) const {
    const auto sets = graph_.sets();
    return std::find(sets.begin(), sets.end(), name) != sets.end();
  }

  [[nodiscard]] int factsWithHead(const std::string& name) const {
    const auto& facts = graph_.facts();
    return static_cast<int>(
        std::count_if(facts.begin(), facts.end(), [&](const knowledge::Fact& f) { return f.head == name; }));
  }

  /// As high as its tags need.
  [[nodiscard]] double titleHeight(const std::string& name, double least) const {
    return std::max(least, factsWithHead(name) * kTagHeight + kGap);
  }

  /// Puts a set or an entity below `y`; returns where it ends.
  double place(const std::string& name, double x, double y, double width) {
    if (boxes_of_.count(name) > 0) return y;
    if (!isSet(name)) {
      // A set that is not in the file has no frame.
      const auto entities = graph_.entities();
      return std::find(entities.begin(), entities.end(), name) == entities.end() ? y : placeEntity(name, x, y, width);
    }
    Box& box = boxes_of_[name];
    box = {x, y, width, 0, titleHeight(name, kTitleHeight), true};
    double bottom = y + box.titleHeight;
    std::ostringstream inside;
    std::swap(inside, boxes_);  // the frame must be drawn before what is in it
    for (const std::string& member : graph_.contents(name)) {
      bottom = place(member, x + 2 * kGap, bottom, width - 4 * kGap) + kGap;
    }
    std::swap(inside, boxes_);
    box.height = bottom + kGap - y;
    boxes_ << "<rect x=\"" << x << "\" y=\"" << y << "\" width=\"" << width << "\" height=\"" << box.height
           << R"(" rx="8" fill="#64748b" fill-opacity="0.08" stroke="#94a3b8"/>)"
           << "<text x=\"" << x + 10 << "\" y=\"" << box.middle() + 4.5 << R"(" font-weight="bold" fill="#334155">)"
           << spoken(name) << "</text>\n"
           << inside.str();
    return y + box.height;
  }

  double placeEntity(const std::string& name, double x, double y, double width) {
    const double height = titleHeight(name, kPillHeight);
    boxes_of_[name] = {x, y, width, height, height, false};
    boxes_ << "<g><title>labels: " << core::escapedForMarkup(joined(graph_.labels(name))) << "</title><rect x=\"" << x
           << "\" y=\"" << y << "\" width=\"" << width << "\" height=\"" << height << R"(" rx="12" fill=")"
           << fillOf(name) << R"(" stroke="#475569"/><text x=")" << x + 12 << "\" y=\"" << y + height / 2 + 4.5 << "\">"
           << spoken(name) << "</text></g>\n";
    return y + height;
  }

  [[nodiscard]] const char* fillOf(const std::string& entity) const {
    switch (graph_.mobility(entity)) {
      case knowledge::Mobility::Moving:
        return "#fed7aa";
      case knowledge::Mobility::Movable:
        return "#bfdbfe";
      case knowledge::Mobility::Static:
        return "#e2e8f0";
    }
    return "white";
  }

  /// Where a name is drawn: its own box, or those of its members where its set has no frame.
  [[nodiscard]] std::vector<std::string> drawnAs(const std::string& name) const {
    if (boxes_of_.count(name) > 0) return {name};
    const auto& members = graph_.members(name);
    return {members.begin(), members.end()};
  }

  void line(const knowledge::Fact& fact) {
    for (const std::string& head : drawnAs(fact.head)) {
      for (const std::string& tail : drawnAs(fact.tail)) line(fact, head, boxes_of_.at(tail));
    }
  }

  void line(const knowledge::Fact& fact, const std::string& head, const Box& tail) {
    const Box& thing = boxes_of_.at(head);
    const int tagNumber = tagsAt_[head]++;
    const double shift = (tagNumber - std::max(factsWithHead(head) - 1, 0) / 2.0) * kTagHeight;
    const double y = thing.middle() + shift;
    const bool movesIt = fact.relation == knowledge::kCanBeMovedBy;
    const std::string colour = colours_.at(fact.tail);
    const bool isOnTheRight = thing.x >= kRight;
    const double tagX = isOnTheRight ? kRight - 12 : thing.x + thing.width - 8;
    const std::string text = tagText(fact);
    const double tagWidth = kLetter * static_cast<double>(text.size()) + 8;

    std::ostringstream path;
    path << std::fixed << std::setprecision(1);
    if (isOnTheRight) {
      const double from = tail.x + tail.width;
      const double to = tagX - tagWidth;
      path << "M" << from << "," << tail.middle() << " C" << from + 150 << "," << tail.middle() << " " << to - 120
           << "," << y << " " << to << "," << y << " M" << tagX << "," << y << " L" << thing.x << "," << y;
    } else {
      path << "M" << tail.x << "," << tail.middle() << " C" << kLeft - 50 << "," << tail.middle() << " " << kLeft - 50
           << "," << y << " " << thing.x << "," << y;
    }
    lines_ << "<path d=\"" << path.str() << R"(" fill="none" stroke=")" << colour << R"(" stroke-opacity="0.75")"
           << " stroke-width=\"" << (movesIt ? 0.8 + 3.2 * fact.bond.strength : 1.0) << "\""
           << (movesIt ? "" : " stroke-dasharray=\"5 4\"") << "/>\n";
    tags_ << R"(<text text-anchor="end" font-size="11" paint-order="stroke" stroke="white" stroke-width="3" x=")"
          << tagX - 4 << "\" y=\"" << y + 4 << "\" fill=\"" << colour << "\">" << core::escapedForMarkup(text)
          << "</text>\n";
  }

  [[nodiscard]] static std::string tagText(const knowledge::Fact& fact) {
    std::string who = fact.tail;
    std::replace(who.begin(), who.end(), '_', ' ');
    if (fact.relation != knowledge::kCanBeMovedBy) {
      std::string relation = fact.relation;
      std::replace(relation.begin(), relation.end(), '_', ' ');
      return relation + " " + who;
    }
    std::ostringstream text;
    text << who << ", " << std::lround(100 * fact.bond.strength) << " %, " << fact.bond.reach_m << " m";
    return text.str();
  }

  [[nodiscard]] static std::string caption() {
    return R"(<text x=")" + std::to_string(static_cast<int>(kLeft)) +
           R"(" y="34" font-size="15">Who can move what: how likely within reach, and how far that is</text>)" + "\n";
  }

  const knowledge::KnowledgeGraph& graph_;
  std::map<std::string, std::string> colours_;  ///< Of each tail of a fact.
  std::map<std::string, Box> boxes_of_;
  std::map<std::string, int> tagsAt_;
  std::ostringstream boxes_;
  std::ostringstream lines_;
  std::ostringstream tags_;
};

}  // namespace

std::string drawSvg(const knowledge::KnowledgeGraph& graph) { return Drawing(graph).draw(); }

}  // namespace wardslam::viewer
