#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "scheduler/step_graph.hpp"

namespace pliant::scheduler {

namespace {

std::string quoted(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string list(const std::vector<Access>& accesses, const std::vector<std::string>& names) {
  std::string result;
  for (const Access& access : accesses) {
    if (!result.empty()) result += ", ";
    result += names[static_cast<std::size_t>(access.field)];
    if (access.reach == Reach::neighbours) result += " (neighbours)";
    if (access.reach == Reach::all) result += " (all)";
  }
  return result.empty() ? "nothing" : result;
}

// Prints one arrow for edges with the same ends, labelled with all their fields.
template <class Name>
void print_edges(std::string& out, const std::vector<Edge>& edges,
                 const std::vector<std::string>& names, Name name) {
  for (std::size_t e = 0; e < edges.size();) {
    std::string fields;
    const Edge ends = edges[e];
    for (; e < edges.size() && edges[e].has_ends_of(ends); ++e)
      fields += (fields.empty() ? "" : ", ") + names[static_cast<std::size_t>(edges[e].field)];
    fmt::format_to(std::back_inserter(out), "  {} -> {} [label=\"{}\"];\n", name(ends.from),
                   name(ends.to), quoted(fields));
  }
}

bool reads_of_others(const Phase& phase, FieldId field) {
  return phase.kind != Phase::Kind::reduce &&
         std::any_of(phase.reads.begin(), phase.reads.end(), [&](const Access& read) {
           return read.field == field && read.reach != Reach::own;
         });
}

// The last exchange between the phases of an edge that sends what the second phase reads; -1: none.
int exchange_on(const Edge& edge, const std::vector<Phase>& phases) {
  const auto phase = [&](int p) -> const Phase& { return phases[static_cast<std::size_t>(p)]; };
  if (!reads_of_others(phase(edge.to), edge.field)) return -1;
  for (int p = edge.to - 1; p > edge.from; --p) {
    if (phase(p).kind == Phase::Kind::exchange && reads_of_others(phase(p), edge.field)) return p;
  }
  return -1;
}

const char* shown(Phase::Kind kind) { return kind == Phase::Kind::reduce ? " (reduce)" : ""; }

}  // namespace

std::vector<Edge> StepGraph::phase_edges() const {
  // An edge into a junction represents edges to everything after it.
  std::vector<std::vector<int>> origins(nodes().size());
  std::vector<Edge> result;
  const auto add_edge = [&](const Edge& edge) {
    if (const int exchange = exchange_on(edge, phases_); exchange >= 0) {
      result.push_back({edge.from, exchange, edge.field});
      result.push_back({exchange, edge.to, edge.field});
    } else {
      result.push_back(edge);
    }
  };
  for (const Edge& edge : edges()) {
    const Node& from = nodes()[static_cast<std::size_t>(edge.from)];
    const Node& to = nodes()[static_cast<std::size_t>(edge.to)];
    const auto add = [&](int phase) {
      if (to.is_junction())
        origins[static_cast<std::size_t>(edge.to)].push_back(phase);
      else
        add_edge({phase, to.phase, edge.field});
    };
    if (from.is_junction())
      for (const int phase : origins[static_cast<std::size_t>(edge.from)]) add(phase);
    else
      add(from.phase);
  }
  std::sort(result.begin(), result.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.to, a.from, a.field) < std::tie(b.to, b.from, b.field);
  });
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::string StepGraph::dot(Detail detail) const {
  std::string out = "digraph step {\n  rankdir=TB;\n  node [shape=box, fontname=\"sans\"];\n";
  detail == Detail::phases ? print_phases(out) : print_blocks(out);
  return out + "}\n";
}

void StepGraph::print_phases(std::string& out) const {
  for (std::size_t p = 0; p < phases_.size(); ++p) {
    const Phase& phase = phases_[p];
    const std::string reads = quoted(list(phase.reads, field_names_));
    if (phase.kind == Phase::Kind::exchange)
      fmt::format_to(std::back_inserter(out), "  phase_{} [shape=ellipse, label=\"{}\\n{}\"];\n", p,
                     quoted(label(phase)), reads);
    else
      fmt::format_to(
          std::back_inserter(out), "  phase_{} [label=\"{}{}\\nreads {}\\nwrites {}\"];\n", p,
          quoted(label(phase)), shown(phase.kind), reads, quoted(list(phase.writes, field_names_)));
  }
  print_edges(out, phase_edges(), field_names_,
              [](int phase) { return fmt::format("phase_{}", phase); });
}

void StepGraph::print_blocks(std::string& out) const {
  const auto print = [&]<class... T>(fmt::format_string<T...> text, T&&... values) {
    fmt::format_to(std::back_inserter(out), text, std::forward<T>(values)...);
  };
  for (std::size_t p = 0; p < phases_.size(); ++p) {
    if (phases_[p].kind == Phase::Kind::exchange) continue;
    print("  subgraph cluster_{} {{\n    label=\"{}\";\n", p, quoted(label(phases_[p])));
    for (std::size_t n = 0; n < nodes().size(); ++n) {
      if (nodes()[n].phase != static_cast<int>(p)) continue;
      if (nodes()[n].is_junction())
        print("    node_{} [shape=point];\n", n);
      else if (phases_[p].kind == Phase::Kind::reduce)
        print("    node_{} [label=\"reduce\"];\n", n);
      else
        print("    node_{} [label=\"{}\"];\n", n, nodes()[n].block);
    }
    print("  }}\n");
  }
  print_edges(out, edges(), field_names_, [](int node) { return fmt::format("node_{}", node); });
}

}  // namespace pliant::scheduler
