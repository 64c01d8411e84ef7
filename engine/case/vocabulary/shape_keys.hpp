#pragma once

#include "engine/case/vocabulary/key.hpp"
#include "engine/case/vocabulary/words.hpp"

namespace pliant {

inline ShapeWord word_of(const Shape& shape, int dimension) {
  switch (shape.kind) {
    case Shape::Kind::box:
      return ShapeWord::box;
    case Shape::Kind::ball:
      return dimension == 2 ? ShapeWord::disc : ShapeWord::ball;
    case Shape::Kind::capsule:
      return ShapeWord::capsule;
    case Shape::Kind::cylinder:
      return ShapeWord::cylinder;
    case Shape::Kind::half_space:
      return ShapeWord::half_space;
    case Shape::Kind::mesh:
      return ShapeWord::mesh;
    case Shape::Kind::unite:
      return ShapeWord::unite;
    case Shape::Kind::subtract:
      return ShapeWord::difference;
    case Shape::Kind::intersect:
      break;
  }
  return ShapeWord::intersection;
}

inline Shape::Kind kind_of(ShapeWord shape) {
  switch (shape) {
    case ShapeWord::box:
      return Shape::Kind::box;
    case ShapeWord::disc:
    case ShapeWord::ball:
      return Shape::Kind::ball;
    case ShapeWord::capsule:
      return Shape::Kind::capsule;
    case ShapeWord::cylinder:
      return Shape::Kind::cylinder;
    case ShapeWord::half_space:
      return Shape::Kind::half_space;
    case ShapeWord::mesh:
      return Shape::Kind::mesh;
    case ShapeWord::unite:
      return Shape::Kind::unite;
    case ShapeWord::difference:
      return Shape::Kind::subtract;
    case ShapeWord::intersection:
      break;
  }
  return Shape::Kind::intersect;
}

template <class Visitor>
void box_keys(Visitor& visit, Shape& shape) {
  visit("lower", shape.lower,
        {.meaning = "lower corner; -inf where the box is unbounded",
         .unit = "m",
         .example = "[0, 0]",
         .limits = finite_or_infinite,
         .required = true});
  visit("upper", shape.upper,
        {.meaning = "upper corner; inf where the box is unbounded",
         .unit = "m",
         .example = "[1, 1]",
         .limits = finite_or_infinite,
         .required = true});
}

template <class Visitor>
void round_keys(Visitor& visit, Shape& shape) {
  if (shape.kind == Shape::Kind::capsule) {
    visit("from", shape.from,
          {.meaning = "first end of the axis", .unit = "m", .example = "[0, 0]", .required = true});
    visit(
        "to", shape.to,
        {.meaning = "second end of the axis", .unit = "m", .example = "[1, 0]", .required = true});
  } else {
    visit("centre", shape.centre,
          {.meaning = "centre, or any point of the axis",
           .unit = "m",
           .example = "[0, 0]",
           .required = true});
  }
  visit("radius", shape.radius,
        {.meaning = "radius", .unit = "m", .example = "1", .limits = positive, .required = true});
  if (shape.kind == Shape::Kind::cylinder) {
    visit("axis", Direction{shape.axis},
          {.meaning = "direction of the axis", .example = "[0, 0, 1]"});
  }
}

template <class Visitor>
void half_space_keys(Visitor& visit, Shape& shape) {
  visit("point", shape.point,
        {.meaning = "any point of the plane", .unit = "m", .example = "[0, 0]", .required = true});
  visit("normal", Direction{shape.normal},
        {.meaning = "outward normal of the half-space; for a wall it points towards the body",
         .example = "[0, 1]",
         .required = true});
}

template <class Visitor>
void mesh_keys(Visitor& visit, Shape& shape) {
  visit(
      "file", shape.file,
      {.meaning = "STL, OBJ or PLY file of a closed surface, or Gmsh (.msh) or VTK (.vtk) file of "
                  "tetrahedra; a relative path starts from the folder of the case file",
       .example = R"("organ.stl")",
       .required = true});
  visit("scale", shape.scale,
        {.meaning = "length of one unit of the file; 0.001 for millimetres",
         .unit = "m",
         .example = "0.001",
         .limits = positive});
  visit("translate", shape.translate,
        {.meaning = "position of the origin of the file", .unit = "m", .example = "[0, 0, 0]"});
}

template <class Visitor>
void shape_keys(Visitor& visit, Shape& shape) {
  ShapeWord word = word_of(shape, visit.dimension());
  const bool known =
      visit("shape", word,
            {.meaning = "kind of shape", .example = R"("box")", .required = true, .decides = true});
  if (!known) return;
  shape.kind = kind_of(word);
  switch (shape.kind) {
    case Shape::Kind::box:
      return box_keys(visit, shape);
    case Shape::Kind::ball:
    case Shape::Kind::capsule:
    case Shape::Kind::cylinder:
      return round_keys(visit, shape);
    case Shape::Kind::half_space:
      return half_space_keys(visit, shape);
    case Shape::Kind::mesh:
      return mesh_keys(visit, shape);
    default:
      visit("of", shape.operands,
            {.meaning = "the parts, two or more",
             .example = R"([{ shape = "box", ... }, { shape = "disc", ... }])",
             .required = true});
  }
}

}  // namespace pliant
