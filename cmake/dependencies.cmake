# Every library the project stands on, found once. docs/architecture.md says why each is here.
find_package(Eigen3 REQUIRED)
find_package(OpenCV 4.6 REQUIRED COMPONENTS core imgproc imgcodecs features2d calib3d dnn flann video)
find_package(mrpt-obs 2.5 REQUIRED)
find_package(mrpt-system REQUIRED)
find_package(mrpt-opengl REQUIRED)
find_package(mrpt-graphs REQUIRED)
find_package(mrpt-graphslam REQUIRED)
find_package(Ceres 2.1 REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Threads REQUIRED)
find_package(PCL 1.13 REQUIRED COMPONENTS common search filters segmentation)

if(NOT TARGET yaml-cpp::yaml-cpp)
  add_library(yaml-cpp::yaml-cpp ALIAS yaml-cpp)  # yaml-cpp 0.7 exports the bare name
endif()
