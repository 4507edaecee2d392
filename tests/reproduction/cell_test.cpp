#include "wardslam/reproduction/cell.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::reproduction {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

constexpr const char* kSummary = R"({"coverage": 1.0, "stages": {}})";
constexpr const char* kEvaluation = R"({"ate": {"rmse": 0.0123}})";

class CellTest : public ::testing::Test {
 protected:
  CellTest() {
    plan_.file = folder_.path() / "plan.yaml";
    plan_.sequences.resize(2);
    plan_.sequences[0].name = plan_.sequences[0].folder = "ward";
    plan_.sequences[0].masks = "masks";
    plan_.sequences[1].name = plan_.sequences[1].folder = "far";
    plan_.variants.resize(2);
    plan_.variants[0].name = "off";
    plan_.variants[0].filter = Filter::Off;
    plan_.variants[1].name = "ours";
    write("rgb.txt", "1.0 rgb/1.png\n");
    write("groundtruth.txt", "1.0 0 0 0 0 0 0 1\n");
    write("rgb/1.png", "12345");
    write("masks/1.png", "123");
  }
  void write(const std::string& name, const std::string& text) const { folder_.write("data/ward/" + name, text); }
  [[nodiscard]] std::filesystem::path data() const { return folder_.path() / "data"; }
  [[nodiscard]] Cell cell(std::size_t sequence, std::size_t variant, int repetition = 0) const {
    return {sequence, variant, repetition, folder_.path() / "out"};
  }
  [[nodiscard]] std::string identity(const std::string& configuration = "features:\n  key_points: 1500\n",
                                     const std::string& version = "1.2.3") const {
    return identityOf(plan_, cell(0, 1), contentsOf(plan_, 0, data()), configuration, version);
  }

  test::TemporaryFolder folder_;
  Plan plan_;
};

TEST_F(CellTest, EverySequenceWithEveryVariantSoManyTimes) {
  plan_.repetitions = 2;
  const auto cells = cellsOf(plan_, "out");
  ASSERT_EQ(cells.size(), 8U);
  EXPECT_EQ(cells[0].folder, "out/cells/ward/off/0");
  EXPECT_EQ(cells[3].folder, "out/cells/far/ours/0") << "all of a repetition come before the next";
  EXPECT_EQ(cells[4].folder, "out/cells/ward/off/1");
}

TEST_F(CellTest, SaysWhyACellCannotBeRun) {
  EXPECT_EQ(whyNot(plan_, cell(0, 0), data()), "");
  EXPECT_EQ(whyNot(plan_, cell(0, 1), data()), "");
  EXPECT_EQ(whyNot(plan_, cell(1, 0), data()), "missing");
  plan_.sequences[0].masks = "";
  EXPECT_EQ(whyNot(plan_, cell(0, 1), data()), "no masks");
  EXPECT_EQ(whyNot(plan_, cell(0, 0), data()), "") << "without a filter nobody asks for masks";
  plan_.variants[1].network = "depth";
  EXPECT_EQ(whyNot(plan_, cell(0, 1), data()), "");
  plan_.sequences[0].ground_truth = "truth.txt";
  EXPECT_EQ(whyNot(plan_, cell(0, 0), data()), "no truth");
}

TEST_F(CellTest, VariantsBecomeOptions) {
  using Type = segmentation::SegmentationOptions::Type;
  const auto off = optionsOf(plan_, cell(0, 0), data());
  EXPECT_EQ(off.segmentation.type, Type::None);
  EXPECT_EQ(off.filters.yaml().size(), 0U);
  EXPECT_FALSE(off.mapping.enabled);

  const auto ours = optionsOf(plan_, cell(0, 1), data());
  EXPECT_EQ(ours.segmentation.type, Type::RecordedMasks);
  EXPECT_EQ(ours.segmentation.recorded_masks.folder, (data() / "ward/masks").string());
  EXPECT_EQ(ours.filters.yaml().size(), 2U);
  EXPECT_EQ(ours.odometry.matcher.max_semantic_difference, 1.0);

  Variant& letter = plan_.variants[1];
  letter.filter = Filter::Paper;
  letter.n = 5;
  letter.delta = 3;
  letter.match_outliers = true;
  const auto paper = optionsOf(plan_, cell(0, 1), data());
  ASSERT_EQ(paper.filters.yaml().size(), 1U);
  const auto parameters = paper.filters.yaml()[0]["params"];
  EXPECT_EQ(parameters["rule"].as<std::string>(), "paper");
  EXPECT_EQ(parameters["n"].as<int>(), 5);
  EXPECT_EQ(parameters["delta"].as<int>(), 3);
  EXPECT_EQ(parameters["margin_px"].as<int>(), 0) << "masks as they are";
  EXPECT_EQ(parameters["bridge_s"].as<double>(), 0.0);
  EXPECT_EQ(paper.segmentation.refinement.refine_contours, masks::ContourRefinementOptions::Refine::Never);
  EXPECT_EQ(paper.odometry.matcher.max_semantic_difference, 0.25) << "the paper's 110 of 441";

  letter.filter = Filter::Geometric;
  const auto geometric = optionsOf(plan_, cell(0, 1), data());
  EXPECT_EQ(geometric.segmentation.type, Type::None);
  ASSERT_EQ(geometric.filters.yaml().size(), 1U);
  EXPECT_THAT(geometric.filters.yaml()[0]["class_name"].as<std::string>(), HasSubstr("GeometricMotionFilter"));
}

TEST_F(CellTest, NetworksAreLookedForBesideThePlan) {
  plan_.variants[1].network = "net.onnx";
  EXPECT_THROW((void)optionsOf(plan_, cell(0, 1), data()), core::InputError);
  const auto file = folder_.write("net.onnx", "weights");
  EXPECT_EQ(optionsOf(plan_, cell(0, 1), data()).segmentation.yolo.model, file.string());
}

TEST_F(CellTest, RepetitionsHaveOtherKeyPoints) {
  const std::string configuration = "features:\n  key_points: 1500\n  levels: 8\n";
  EXPECT_EQ(withKeyPoints(configuration, 0), configuration);
  EXPECT_EQ(withKeyPoints(configuration, -20), "features:\n  key_points: 1480\n  levels: 8\n");
  EXPECT_THAT([&] { (void)withKeyPoints(configuration, -1460); },
              ThrowsMessage<core::InputError>(HasSubstr("40 key points; 50 are the least")));
}

TEST_F(CellTest, AnythingThatDeterminesARunIsInItsIdentity) {
  const std::string before = identity();
  EXPECT_EQ(identity(), before);
  EXPECT_NE(identity("features:\n  key_points: 1520\n"), before);
  EXPECT_NE(identity("features:\n  key_points: 1500\n", "1.2.4"), before);
  plan_.max_frames = 5;
  EXPECT_NE(identity(), before);
  plan_.max_frames = 0;
  const auto changesIt = [&](const std::string& name, const std::string& text, const std::string& old) {
    write(name, text);
    const bool isOther = identity() != before;
    write(name, old);
    return isOther && identity() == before;
  };
  EXPECT_TRUE(changesIt("rgb.txt", "1.5 rgb/1.png\n", "1.0 rgb/1.png\n"));
  EXPECT_TRUE(changesIt("groundtruth.txt", "1.0 1 0 0 0 0 0 1\n", "1.0 0 0 0 0 0 0 1\n"));
  EXPECT_TRUE(changesIt("masks/1.png", "1234", "123"));
  EXPECT_TRUE(changesIt("rgb/1.png", "123456", "12345"));
  plan_.variants[1].network = "net.onnx";
  folder_.write("net.onnx", "weights");
  const std::string withNetwork = identity();
  folder_.write("net.onnx", "better");
  EXPECT_NE(identity(), withNetwork);
}

TEST_F(CellTest, IsFinishedOnceItsEvaluationIsThere) {
  const Cell ours = cell(0, 1);
  EXPECT_FALSE(finishedResult(ours, "who"));
  beginCell(ours, "who");
  folder_.write("out/run/summary.json", kSummary);
  EXPECT_FALSE(finishedResult(ours, "who")) << "a run alone is none";
  EXPECT_EQ(finishCell(ours, kEvaluation, "").ate_rmse_m, 0.0123);
  ASSERT_TRUE(finishedResult(ours, "who"));
  EXPECT_EQ(finishedResult(ours, "who")->ate_rmse_m, 0.0123);
  EXPECT_FALSE(finishedResult(ours, "who else"));

  folder_.write("out/result.json", "{");
  EXPECT_FALSE(finishedResult(ours, "who")) << "damaged";
}

TEST_F(CellTest, WhatCannotBeComparedIsFinishedToo) {
  beginCell(cell(0, 1), "who");
  folder_.write("out/run/summary.json", kSummary);
  (void)finishCell(cell(0, 1), "", "there are 0 poses");
  ASSERT_TRUE(finishedResult(cell(0, 1), "who"));
  EXPECT_EQ(finishedResult(cell(0, 1), "who")->trouble, "there are 0 poses");
}

TEST_F(CellTest, BeginningAnewLeavesNothingOfTheOldRun) {
  folder_.write("out/run/summary.json", kSummary);
  folder_.write("out/result.json", "{}");
  beginCell(cell(0, 1), "who");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out/run"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out/result.json"));
}

}  // namespace
}  // namespace wardslam::reproduction
