#include "output/rests.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <vector>

namespace wardslam::synth {
namespace {

void write(std::ostream& text, const Label& label, const RestInterval& rest, double until_s) {
  text << label.id << "," << label.name << "," << static_cast<int>(label.classId) << "," << label.className << ","
       << rest.from_s << ",";
  if (rest.until_s < until_s) text << rest.until_s;
  for (const Eigen::Vector3f& p : {Eigen::Vector3f(rest.bounds_m.center()), rest.bounds_m.min(), rest.bounds_m.max()})
    text << "," << p.x() << "," << p.y() << "," << p.z();
  text << "\n";
}

}  // namespace

std::string restsText(const Scene& scene, double until_s) {
  std::vector<const Actor*> actors;
  for (const auto& actor : scene.actors) actors.push_back(actor.get());
  std::sort(actors.begin(), actors.end(), [](const Actor* a, const Actor* b) { return a->label().id < b->label().id; });
  std::ostringstream text;
  text << "instance_id,name,class_id,class_name,from_s,until_s,cx,cy,cz,xmin,ymin,zmin,xmax,ymax,zmax\n"
       << std::fixed << std::setprecision(3);
  for (const Actor* actor : actors) {
    for (const RestInterval& rest : actor->restsUntil(until_s)) write(text, actor->label(), rest, until_s);
  }
  return text.str();
}

}  // namespace wardslam::synth
