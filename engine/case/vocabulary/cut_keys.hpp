#pragma once

#include "engine/case/vocabulary/key.hpp"

namespace pliant {

/// Place and motion of a blade.
template <class Visitor>
void blade_keys(Visitor& visit, CutCase& cut) {
  visit("track", FilePath{cut.track.file},
        {.meaning = "recorded path of the edge in the undeformed body, instead of from, to, path, "
                    "start and end: CSV with the header time,x,y in 2D; "
                    "time,x1,y1,z1,x2,y2,z2 (both ends) or time,x,y,z,qw,qx,qy,qz (start, and a "
                    "quaternion that turns edge) in 3D; interpolated linearly between rows",
         .example = R"("scalpel.csv")"});
  visit(
      "edge", cut.edge,
      {.meaning = "vector from the start of the edge to its end, in 3D, instead of to: numbers or "
                  "formulas of t",
       .unit = "m",
       .example = R"toml([0, "0.01*sin(t)", "-0.01*cos(t)"])toml",
       .variables = "t"});
  if (!cut.track.file.empty()) return;
  visit("from", cut.from,
        {.meaning = "start of the blade's edge at time start, in the undeformed body; in 2D the "
                    "edge is this point; required without a track, like path and end",
         .unit = "m",
         .example = "[0, 0, 1]"});
  visit("to", cut.to,
        {.meaning = "end of the edge, in 3D; tissue beyond it stays whole",
         .unit = "m",
         .example = "[0, 0, 0.5]"});
  visit("path", cut.path,
        {.meaning = "displacement of the edge since time start, in the undeformed body, numbers or "
                    "formulas of t",
         .unit = "m",
         .example = R"toml(["0.1*t", 0, 0])toml",
         .variables = "t"});
  visit("start", cut.start,
        {.meaning = "time at which the blade starts to cut",
         .unit = "s",
         .example = "0.5",
         .limits = not_negative});
  visit("end", cut.end,
        {.meaning = "time at which the blade stops cutting",
         .unit = "s",
         .example = "1",
         .limits = not_negative});
}

template <class Visitor>
void cut_keys(Visitor& visit, CutCase& cut) {
  visit("name", Name{cut.name},
        {.meaning = "name, to which measurements and --set refer",
         .example = R"("scalpel")",
         .required = true});
  visit("body", BodyName{cut.body}, {.meaning = "name of the body; by default the first one"});
  blade_keys(visit, cut);
  visit("resistance", cut.resistance,
        {.meaning = "energy that new cut faces take from the blade, per undeformed area (PB.18)",
         .unit = "J/m^2",
         .example = "200",
         .limits = not_negative});
  visit("friction", cut.friction,
        {.meaning = "friction of the moving blade, a force per length of its edge in the body "
                    "(PB.18)",
         .unit = "N/m",
         .example = "5",
         .limits = not_negative});
  visit("drag", cut.drag,
        {.meaning =
             "viscous friction, a force per length of the edge and per velocity relative to the "
             "tissue (PB.18)",
         .unit = "Pa s",
         .example = "20",
         .limits = not_negative});
  visit("puncture_force", cut.puncture_force,
        {.meaning = "force on the surface at which the blade enters the body, per unit thickness "
                    "in 2D; until then it dents the body (PB.35); 0 enters at once",
         .unit = "N",
         .example = "0.5",
         .limits = not_negative});
}

}  // namespace pliant
