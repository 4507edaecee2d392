#include "wardslam/query/object_name.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <vector>

#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"

namespace wardslam::query {
namespace {

/// A name taken apart.
struct Wanted {
  std::string className;  ///< Empty: any.
  std::optional<std::uint32_t> id;
  std::optional<std::uint32_t> number;
};

std::string spaced(std::string text) {
  std::replace(text.begin(), text.end(), '_', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

std::optional<std::uint32_t> wholeNumber(const std::string& text) {
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

Wanted takeApart(const std::string& name) {
  const std::string text = spaced(name);
  const auto space = text.rfind(' ');
  const std::string last = space == std::string::npos ? text : text.substr(space + 1);
  const std::string before = space == std::string::npos ? "" : spaced(text.substr(0, space));
  if (!last.empty() && last.front() == '#') {
    if (const auto id = wholeNumber(last.substr(1))) return {before, id, {}};
  }
  if (const auto number = wholeNumber(last); number && !before.empty()) return {before, {}, number};
  return {text, {}, {}};
}

std::string classNameOf(const mapping::MapObject& object, const mapping::SemanticMap& map) {
  const std::string& name = map.labels.name(object.classId);
  return name.empty() ? "class " + std::to_string(object.classId) : spaced(name);
}

/// In order of ids, those that are gone included.
std::vector<const mapping::MapObject*> objectsOf(const std::string& className, const mapping::SemanticMap& map) {
  std::vector<const mapping::MapObject*> found;
  for (const auto& [id, object] : map.objects) {
    if (classNameOf(object, map) == className) found.push_back(&object);
  }
  return found;
}

std::string listOf(const std::vector<const mapping::MapObject*>& objects, const mapping::SemanticMap& map) {
  constexpr std::size_t kMost = 12;
  std::string list;
  for (std::size_t i = 0; i < std::min(kMost, objects.size()); ++i)
    list += (i > 0 ? ", " : "") + nameOf(*objects[i], map);
  return list + (objects.size() > kMost ? ", ..." : "");
}

[[noreturn]] void failNoClass(const Wanted& wanted, const std::string& name, const mapping::SemanticMap& map) {
  std::vector<std::string> classes;
  for (const auto& [id, object] : map.objects) classes.push_back(classNameOf(object, map));
  if (classes.empty()) throw core::InputError("the map holds no objects, so no '" + name + "'");
  throw core::InputError("the map holds no '" + wanted.className + "'; did you mean '" +
                         core::nearestName(wanted.className, classes) + "'?");
}

const mapping::MapObject& standing(const mapping::MapObject& object, const mapping::SemanticMap& map) {
  if (object.state != mapping::ObjectState::Gone) return object;
  throw core::InputError(nameOf(object, map) + " is gone: its place has since been seen empty");
}

const mapping::MapObject& byId(const Wanted& wanted, const std::string& name, const mapping::SemanticMap& map) {
  const auto found = map.objects.find(*wanted.id);
  if (found == map.objects.end()) throw core::InputError("the map holds no object '" + name + "'");
  if (!wanted.className.empty() && classNameOf(found->second, map) != wanted.className)
    throw core::InputError("object #" + std::to_string(*wanted.id) + " is no '" + wanted.className + "' but " +
                           nameOf(found->second, map));
  return standing(found->second, map);
}

/// Of those that stand there the only one.
const mapping::MapObject& onlyOne(const std::vector<const mapping::MapObject*>& objects, const std::string& name,
                                  const mapping::SemanticMap& map) {
  std::vector<const mapping::MapObject*> there;
  for (const auto* object : objects) {
    if (object->state != mapping::ObjectState::Gone) there.push_back(object);
  }
  if (there.empty()) return standing(*objects.front(), map);
  if (there.size() == 1) return *there.front();
  throw core::InputError("'" + name + "' could be any of " + listOf(there, map) + "; say which");
}

}  // namespace

const mapping::MapObject& objectNamed(const mapping::SemanticMap& map, const std::string& name) {
  const Wanted wanted = takeApart(name);
  if (wanted.id) return byId(wanted, name, map);
  const auto objects = objectsOf(wanted.className, map);
  if (objects.empty()) failNoClass(wanted, name, map);
  if (!wanted.number) return onlyOne(objects, name, map);
  if (*wanted.number == 0 || *wanted.number > objects.size())
    throw core::InputError("the map holds no '" + name + "', only " + listOf(objects, map));
  return standing(*objects[*wanted.number - 1], map);
}

std::string nameOf(const mapping::MapObject& object, const mapping::SemanticMap& map) {
  const std::string className = classNameOf(object, map);
  const auto objects = objectsOf(className, map);
  const auto place = std::find_if(objects.begin(), objects.end(), [&](const auto* o) { return o->id == object.id; });
  return className + " " + std::to_string(place - objects.begin() + 1);
}

}  // namespace wardslam::query
