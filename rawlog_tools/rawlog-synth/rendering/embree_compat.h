#pragma once

// Embree 3 (Debian 12) and 4 (Debian 13) alike: WARDSLAM_EMBREE_MAJOR says which was found.
#if WARDSLAM_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace wardslam::synth {

/// First hits of eight rays that lie close together; lanes where `valid` is 0 are left alone, -1 takes part.
inline void intersectTogether(const int* valid, RTCScene scene, RTCRayHit8& rays) {
#if WARDSLAM_EMBREE_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect8(valid, scene, &rays, &arguments);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid, scene, &context, &rays);
#endif
}

}  // namespace wardslam::synth
