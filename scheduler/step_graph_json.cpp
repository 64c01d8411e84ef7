#include <nlohmann/json.hpp>

#include "scheduler/step_graph.hpp"

namespace pliant::scheduler {

namespace {

using Json = nlohmann::ordered_json;

const char* name(Reach reach) {
  switch (reach) {
    case Reach::own:
      return "own";
    case Reach::neighbours:
      return "neighbours";
    case Reach::all:
      return "all";
  }
  return "";
}

const char* name(Phase::Kind kind) {
  switch (kind) {
    case Phase::Kind::per_block:
      return "per_block";
    case Phase::Kind::reduce:
      return "reduce";
    case Phase::Kind::exchange:
      return "exchange";
  }
  return "";
}

Json json_list(const std::vector<Access>& accesses, const std::vector<std::string>& names) {
  Json result = Json::array();
  for (const Access& access : accesses)
    result.push_back(
        {{"field", names[static_cast<std::size_t>(access.field)]}, {"reach", name(access.reach)}});
  return result;
}

// One entry for edges with the same ends, with all their fields.
Json json_list(const std::vector<Edge>& edges, const std::vector<std::string>& names) {
  Json result = Json::array();
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (e == 0 || !edges[e].has_ends_of(edges[e - 1]))
      result.push_back({{"from", edges[e].from}, {"to", edges[e].to}, {"fields", Json::array()}});
    result.back()["fields"].push_back(names[static_cast<std::size_t>(edges[e].field)]);
  }
  return result;
}

}  // namespace

std::string StepGraph::json() const {
  Json phases = Json::array(), nodes_list = Json::array();
  for (const Phase& phase : phases_)
    phases.push_back({{"name", phase.name},
                      {"stage", phase.stage},
                      {"kind", name(phase.kind)},
                      {"reads", json_list(phase.reads, field_names_)},
                      {"writes", json_list(phase.writes, field_names_)}});
  for (const Node& node : nodes()) {
    Json entry = {{"phase", node.phase}};
    if (node.is_junction())
      entry["junction"] = true;
    else
      entry["block"] = node.block;
    nodes_list.push_back(std::move(entry));
  }
  const Json graph = {{"fields", field_names_},
                      {"blocks", blocks_.count()},
                      {"phases", std::move(phases)},
                      {"nodes", std::move(nodes_list)},
                      {"edges", json_list(edges(), field_names_)},
                      {"phase_edges", json_list(phase_edges(), field_names_)}};
  return graph.dump(1) + "\n";
}

}  // namespace pliant::scheduler
