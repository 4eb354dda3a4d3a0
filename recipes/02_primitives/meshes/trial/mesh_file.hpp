#pragma once

/// \file
/// \brief A mesh from a file: OBJ, or STL as text or binary, with errors by line.

#include "02_primitives/meshes/triangle_mesh.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>

namespace cookbook
{

/// What a wrong mesh file is answered with: `path:line: sentence`; of a binary file `path:
/// sentence`.
class MeshFileError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Reads the text of an OBJ file: corners `v x y z`, and faces `f` of three or more corners, by
/// number from one, or from the last by negative numbers. Faces are parted into a fan of
/// triangles. Normals, textures, names and materials are passed over.
///
/// `name` is the file's, for errors. MeshFileError for anything else.
TriangleMesh<double> mesh_from_obj(const std::string& text, const std::string& name);

/// Reads an STL file, text or binary; corners at the same place become one.
///
/// Stated normals and attributes are passed over. MeshFileError for anything else.
TriangleMesh<double> mesh_from_stl(const std::string& bytes, const std::string& name);

/// Reads a mesh from a file that ends in `.obj` or `.stl`, and checks it.
///
/// MeshFileError for another name, or a file that cannot be read.
TriangleMesh<double> read_mesh(const std::filesystem::path& path);

} // namespace cookbook
