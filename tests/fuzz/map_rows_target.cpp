#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "choices.h"
#include "fuzz_input.h"
#include "support/hand_made_map.h"
#include "use_of_map.h"
#include "wardslam/core/blob.h"

namespace {

using namespace wardslam;
using Bytes = std::vector<std::uint8_t>;

struct Column {
  std::string table;
  std::string name;
};

/// Something of each that is remembered.
mapping::MapMemory memoryOf(const mapping::SemanticMap& map) {
  mapping::MapMemory memory;
  for (const auto& [id, object] : map.objects) {
    memory.objects[id].votes[object.classId] = 3.5;
    memory.objects[id].views = object.views;
    memory.objects[id].lastPlace_m = object.centroid_m.cast<float>();
  }
  memory.pairs[{1, 2}] = {3, 1};
  mapping::PointMemory point;
  point.p_cam_m = {0.1F, 0.2F, 2.0F};
  point.precision_m2 = 100.0F;
  point.votes[0] = {1, 2.0F};
  memory.tiles[1].assign(5, point);
  return memory;
}

/// The hand-made ward as bytes of its file, and its columns.
struct Ward {
  Bytes bytes;
  std::vector<Column> columns;

  Ward() {
    auto map = test::makeWard();
    map.floorPlan.cells = map.floorPlan.cells(cv::Rect(70, 85, 24, 30)).clone();  // small, to be quick
    auto changes = storage::everythingOf(map);
    for (const auto& [id, keyframe] : map.keyframes) changes.views.push_back(test::makeView(id, map));
    changes.loops = {{1, 3, Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3))}};
    changes.memory = memoryOf(map);
    const auto file = fuzz::scratch().path() / "ward.wardmap";
    storage::MapFile::create(file, {map.labels, "features:\n  key_points: 1000\n"}).write(changes);
    if (!storage::MapFile::open(file).check().empty()) std::abort();
    std::ifstream in(file, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), {});
    SQLite::Database database(file.string());
    SQLite::Statement find(database,
                           "SELECT m.name, c.name FROM sqlite_master m, pragma_table_info(m.name) c "
                           "WHERE m.type = 'table' AND m.name NOT LIKE 'object_boxes_%' ORDER BY m.name, c.cid");
    while (find.executeStep()) columns.push_back({find.getColumn(0), find.getColumn(1)});
  }
};

/// Content of a packed blob altered and packed again, so that it is looked into; nothing where it is none.
std::optional<Bytes> altered(const Bytes& blob, fuzz::Choices& choices) {
  if (blob.size() < 2) return std::nullopt;
  const auto kind = static_cast<core::BlobKind>(blob[0]);
  Bytes content;
  try {
    content = core::unpack(kind, blob[1], blob);
  } catch (const core::BlobError&) {
    return std::nullopt;
  }
  if (choices.below(4) == 0) content.resize(choices.take<std::uint16_t>());
  for (std::size_t edits = 1 + choices.below(4); edits > 0 && !content.empty(); --edits) {
    content[choices.take<std::uint16_t>() % content.size()] = choices.take<std::uint8_t>();
  }
  return core::pack(kind, blob[1], content);
}

/// One value of one row becomes another.
void falsify(SQLite::Database& database, const Ward& ward, fuzz::Choices& choices) {
  const Column& column = ward.columns[choices.take<std::uint16_t>() % ward.columns.size()];
  const std::size_t rows =
      static_cast<std::size_t>(database.execAndGet("SELECT count(*) FROM " + column.table).getInt64());
  if (rows == 0) return;
  const std::size_t row = choices.below(rows);
  const std::string which = " FROM " + column.table + " LIMIT 1 OFFSET " + std::to_string(row);
  const SQLite::Column value = database.execAndGet("SELECT " + column.name + which);
  SQLite::Statement update(database, "UPDATE OR IGNORE " + column.table + " SET " + column.name + " = ? WHERE " +
                                         column.name + " IS (SELECT " + column.name + which + ")");
  if (value.isBlob()) {
    const auto* first = static_cast<const std::uint8_t*>(value.getBlob());
    const auto blob = altered({first, first + value.getBytes()}, choices);
    if (!blob) return;
    update.bind(1, blob->data(), static_cast<int>(blob->size()));
  } else {
    switch (choices.below(4)) {
      case 0:
        update.bind(1, choices.take<std::int64_t>());
        break;
      case 1:
        update.bind(1, static_cast<std::int64_t>(choices.take<std::int8_t>()));
        break;
      case 2:
        update.bind(1, choices.take<double>());
        break;
      default:
        update.bind(1, std::string(choices.below(40), 'x'));
        break;
    }
  }
  update.exec();
}

}  // namespace

// A sound map some of whose values were changed: none of what the input chooses may do more than be found.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Ward ward;
  const auto file = fuzz::scratch().write("rows.wardmap", ward.bytes.data(), ward.bytes.size());
  fuzz::Choices choices(data, size);
  try {
    SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
    database.exec("PRAGMA synchronous = OFF; PRAGMA journal_mode = OFF; PRAGMA ignore_check_constraints = ON");
    for (int edits = 0; edits < 4 && choices.areLeft(); ++edits) falsify(database, ward, choices);
  } catch (const SQLite::Exception&) {
    return 0;  // the database itself would not have it
  }
  fuzz::mayRefuse([&] { fuzz::useMap(file); });
  return 0;
}
