#pragma once

#include <string_view>
#include <unordered_map>

#include "engine/geometry/mesh_files/mesh_file.hpp"
#include "engine/geometry/volume_mesh.hpp"

/// Common parts of the readers of volume meshes.
namespace pliant {

/// Unchecked nodes and elements of a file, with their offsets in the file for messages.
class VolumeMeshRows {
 public:
  VolumeMeshRows(const MeshFile& file, int dimension, bool is_text)
      : file_(file), dimension_(dimension), is_text_(is_text) {}

  /// A node from the row at byte `offset`; elements refer to it by `tag`.
  void add_node(std::size_t offset, std::int64_t tag, const Vector& position);
  /// Whether a kind of element with `corners` corners fills the body; false for elements on its
  /// boundary. Throws MeshError for other kinds; `name` is the kind.
  bool takes(std::size_t offset, int element_dimension, int corners, std::string_view name) const;
  /// An element between D + 1 nodes with these numbers in the file.
  void add_element(std::size_t offset, const std::int64_t* tags);
  /// The checked mesh.
  VolumeMesh mesh() const;

  /// Throws MeshError with the line in a text file or the byte in a binary file.
  [[noreturn]] void refuse(std::size_t offset, const std::string& what,
                           const std::string& remedy) const;

 private:
  void drop_unused(VolumeMesh& mesh, std::vector<std::size_t>& node_at) const;
  void check_nodes(const VolumeMesh& mesh, const std::vector<std::size_t>& node_at) const;
  void orient(VolumeMesh& mesh) const;
  void check_facets(const VolumeMesh& mesh) const;

  const MeshFile& file_;
  int dimension_;
  bool is_text_;
  std::vector<Vector> nodes_;
  std::vector<std::size_t> node_at_;
  std::unordered_map<std::int64_t, std::int32_t> index_of_;  ///< by number in the file
  std::vector<std::array<std::int32_t, 4>> elements_;
  std::vector<std::size_t> element_at_;
};

VolumeMesh read_gmsh(const MeshFile& file, int dimension);
VolumeMesh read_vtk(const MeshFile& file, int dimension);

}  // namespace pliant
