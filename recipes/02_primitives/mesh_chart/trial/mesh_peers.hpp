#pragma once

/// \file
/// \brief Other libraries' meshes, asked for rays and closest points, to be timed beside ours.

#include "02_primitives/mesh_chart/trial/cgal_mesh.hpp"
#include "02_primitives/meshes/triangle_mesh.hpp"
#include "02_primitives/shapes/shapes.hpp"
#include "02_primitives/shapes/trial/bullet_shapes.hpp"

#ifdef COOKBOOK_HAS_BULLET
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#endif
#ifdef COOKBOOK_HAS_EMBREE
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#endif
#ifdef COOKBOOK_HAS_FCL
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>

namespace cookbook
{

#ifdef COOKBOOK_HAS_EMBREE
/// A mesh in Embree, without gaps, on one thread.
class EmbreeMesh
{
public:
  /// Copies the mesh and builds its tree.
  explicit EmbreeMesh(const TriangleMesh<float>& mesh)
  {
    const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
        mesh.vertices.size()));
    for (const Vector3<float>& vertex : mesh.vertices)
    {
      corner = std::copy(vertex.begin(), vertex.end(), corner);
    }
    auto* number = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
        mesh.triangles.size()));
    for (const std::array<int, 3>& triangle : mesh.triangles)
    {
      number = std::copy(triangle.begin(), triangle.end(), number);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene_.get());
  }

  /// The t of a ray's nearest hit.
  std::optional<float> cast(const Ray<float>& ray) const
  {
    const Vector3<float>&o = ray.origin, &d = ray.direction;
    RTCRayHit hit{};
    hit.ray = {
        o.x(), o.y(), o.z(), 0, d.x(), d.y(), d.z(), 0, std::numeric_limits<float>::infinity(),
        ~0u,   0,     0};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene_.get(), &hit);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_.get(), &context, &hit);
#endif
    return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::nullopt : std::optional(hit.ray.tfar);
  }

private:
  struct Release
  {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device_{rtcNewDevice("threads=1")};
  std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> scene_{rtcNewScene(device_.get())};
};
#endif

#ifdef COOKBOOK_HAS_BULLET
/// A mesh in Bullet, with its own tree.
class BulletMesh
{
public:
  /// Copies the mesh and builds its tree.
  explicit BulletMesh(const TriangleMesh<float>& mesh)
  {
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
    {
      const Triangle<float> t = triangle_of(mesh, i);
      triangles_.addTriangle(of_bullet(t.a), of_bullet(t.b), of_bullet(t.c));
    }
    shape_ = std::make_unique<btBvhTriangleMeshShape>(&triangles_, true);
  }

  /// The t of a ray's nearest hit, up to 4.
  std::optional<float> cast(const Ray<float>& ray) const
  {
    BulletRay met(ray, 4);
    shape_->performRaycast(&met, met.m_from, met.m_to);
    return met.t();
  }

private:
  btTriangleMesh triangles_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
};
#endif

#ifdef COOKBOOK_HAS_FCL
/// A mesh in FCL, with boxes that are turned as the triangles lie; in double, as its library comes.
class FclMesh
{
public:
  /// Copies the mesh and builds its tree.
  explicit FclMesh(const TriangleMesh<float>& mesh)
  {
    model_.beginModel();
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
    {
      const Triangle<float> t = triangle_of(mesh, i);
      model_.addTriangle(t.a.cast<double>(), t.b.cast<double>(), t.c.cast<double>());
    }
    model_.endModel();
  }

  /// Whether a segment from the ray's origin to t = 4 meets the mesh: FCL has no rays, and the
  /// segment is a mesh of one flat triangle.
  bool is_met(const Ray<float>& ray) const
  {
    const fcl::Vector3d origin = ray.origin.cast<double>();
    const fcl::Vector3d end = (ray.origin + 4 * ray.direction).cast<double>();
    Model segment;
    segment.beginModel(1, 3);
    segment.addTriangle(origin, end, end);
    segment.endModel();
    const auto none = fcl::Transform3d::Identity();
    fcl::CollisionResultd result;
    return fcl::collide(&model_, none, &segment, none, fcl::CollisionRequestd(), result) > 0;
  }

  /// How far a point is.
  double distance(const Vector3<float>& point) const
  {
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    pose.translation() = point.cast<double>();
    fcl::DistanceResultd result;
    return fcl::distance(
        &model_, fcl::Transform3d::Identity(), &point_, pose, fcl::DistanceRequestd(), result);
  }

private:
  using Model = fcl::BVHModel<fcl::OBBRSSd>;
  Model model_;
  fcl::Sphered point_{0};
};
#endif

} // namespace cookbook
