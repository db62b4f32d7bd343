// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Lets every kind of call fail at one allocation after the other, and cancels it at every report of its progress. The call must end with
// std::bad_alloc or Error{Cancelled}, free all it took, leave its operands as they were and give the same result when made again.
// usage: failed_calls [--tries N]   (of a call that allocates more than N times, N spread over them; 0: all; default 1000)
// A program of its own and no test case: it replaces operator new. Its last line is counted by scripts/test.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

#include "boolean/evaluation.h"
#include "mortise/mesh/half_space.h"
#include "mortise/mortise.h"
#include "support/boolean_scenes.h"
#include "support/data_checks.h"

using namespace mortise;
using namespace mortise::test;

namespace {

enum class Failure {
  None,
  OneAllocation,
  AllLaterAllocations,  ///< this one and all later ones, as where memory has run out
  Cancellation,
};

/// What the replaced operator new knows and does.
struct Memory {
  long long live = 0;              ///< allocations not freed yet
  unsigned long long made = 0;     ///< allocations since the last arm()
  unsigned long long failing = 0;  ///< the number of the one that fails; 0: none
  bool is_lasting = false;         ///< all later ones fail too
  bool was_told = false;           ///< a null pointer answered an allocation that says it takes one, as std::stable_sort's

  void arm(unsigned long long number, bool lasting) {
    made = 0;
    failing = number;
    is_lasting = lasting;
    was_told = false;
  }
  void* allocate(std::size_t size) {
    ++made;
    const bool fails = failing != 0 && (made == failing || (made > failing && is_lasting));
    void* const place = fails ? nullptr : std::malloc(std::max<std::size_t>(size, 1));
    live += place == nullptr ? 0 : 1;
    return place;
  }
  void free(void* place) {
    live -= place == nullptr ? 0 : 1;
    std::free(place);
  }
};

Memory memory;
const char* running = "no call";

}  // namespace

// The other forms of new and delete call these. Inlined, gcc would see memory of operator new given to free().
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* const place = memory.allocate(size)) return place;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  void* const place = memory.allocate(size);
  if (place == nullptr) memory.was_told = true;
  return place;
}
[[gnu::noinline]] void operator delete(void* place) noexcept { memory.free(place); }
[[gnu::noinline]] void operator delete(void* place, std::size_t) noexcept { memory.free(place); }

namespace {

// ---- a number that two results have in common only when they have the same bits

class Digest {
 public:
  template <class T>
  Digest& add(const std::vector<T>& values) {
    add(values.size());
    for (const T& value : values) add(value);
    return *this;
  }
  Digest& add(const std::string& text) { return add(text.size()).add_bytes(text.data(), text.size()); }
  template <class T>
  requires std::is_trivially_copyable_v<T> Digest& add(const T& value) { return add_bytes(&value, sizeof value); }
  Digest& add(const SurfaceMesh& mesh) {
    add(mesh.points).add(mesh.triangles).add(mesh.face_labels).add(mesh.label_names).add(mesh.walls).add(mesh.diagonals);
    return add(mesh.vertex_data).add(mesh.corner_data);
  }
  Digest& add(const DataChannel& c) { return add(c.name).add(c.components).add(c.kind).add(c.values); }
  Digest& add(const BooleanResult& result) {
    const Provenance& p = result.provenance;
    add(result.mesh).add(p.source_operand).add(p.source_face).add(p.flipped).add(p.category).add(p.covering).add(p.covering_sets);
    add(p.covering_front).add(p.other_source_begin).add(p.other_source_operand).add(p.other_source_face).add(p.other_source_flipped);
    add(p.vertex_operand).add(p.vertex_source);
    add(result.graph.points).add(result.graph.edges).add(result.graph.chains);
    return add(result.report.self_contacts).add(result.report.notes).add(result.report.certificate.repair_displacement);
  }
  Digest& add(const MeshPart& part) { return add(part.mesh).add(part.source_face).add(part.source_vertex); }
  [[nodiscard]] unsigned long long value() const { return value_; }

 private:
  Digest& add_bytes(const void* bytes, std::size_t size) {
    const unsigned char* const first = static_cast<const unsigned char*>(bytes);
    for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ first[i]) * 0x100000001b3ULL;
    return *this;
  }

  unsigned long long value_ = 0xcbf29ce484222325ULL;
};

// ---- the operands and the calls

/// Coplanar and partial contacts, parts that overlap, a part that crosses itself, a sheet, coordinates far apart with data, slivers that
/// only a repair certifies, a solid that is inside out, and a mesh with faults to mend and data.
struct Operands {
  std::vector<SurfaceMesh> touching{joined({box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})}), with_chart(box({2, 0, 0}, {4, 2, 2})),
                                    make_mesh({{-1, -1, 0.5}, {5, -1, 0.5}, {5, 5, 1.25}, {-1, 5, 1.25}}, {{0, 1, 2}, {0, 2, 3}})};
  std::vector<SurfaceMesh> crossing{pentagram_prism(0, 2), box({-0.5, -0.5, -1}, {0.5, 0.5, 3})};
  std::vector<SurfaceMesh> slanted{with_chart(box({0, 0, 0}, {1, 1, 1})),
                                   with_chart(tetrahedron({0.3, 1e-170, -0.5}, {1.7, 0.3, 1e-160}, {0.2, 1.6, 0.5}, {1e-150, 0.3, 1.9}))};
  std::vector<SurfaceMesh> slivers{make_icosphere(1, 0), transform(make_icosphere(1, 0), rotation(Axis::X, 1e-13))};
  std::vector<SurfaceMesh> refused{box({0, 0, 0}, {2, 2, 2}), inside_out(box({1, 1, 1}, {3, 3, 3}))};
  std::vector<SurfaceMesh> faulty{with_chart(faulty_box())};
  SurfaceMesh hill = make_mesh({{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}, {1, 1, 2}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});

  [[nodiscard]] unsigned long long digest() const {
    return Digest().add(touching).add(crossing).add(slanted).add(slivers).add(refused).add(faulty).add(hill).value();
  }

 private:
  /// A hole, a face twice, a face without area, a face the wrong way and a shell that is inside out.
  static SurfaceMesh faulty_box() {
    SurfaceMesh mesh = joined({box({0, 0, 0}, {2, 2, 2}), inside_out(box({3, 0, 0}, {4, 1, 1}))});
    mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);
    std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
    mesh.triangles.push_back(mesh.triangles[1]);
    mesh.triangles.push_back({VertexId(8), VertexId(8), VertexId(9)});
    return mesh;
  }
};

const Operands operands;

struct Call {
  const char* name;
  std::function<unsigned long long(const BooleanOptions&)> run;  ///< the digest of its result
};

unsigned long long digest_of(const BooleanResult& result) {
  const ResultRegions regions = find_result_regions(result);
  Digest digest;
  digest.add(result).add(regions.region_of_facet).add(regions.region_in_front);
  for (const ResultRegion& region : regions.regions) digest.add(region.operands).add(region.volume).add(region.area);
  return digest.value();
}

unsigned long long digest_of(const ImprintResult& result) {
  Digest digest;
  digest.add(digest_of(result.whole));
  for (const ImprintedOperand& o : result.operands) {
    digest.add(o.mesh).add(o.vertex_ids).add(o.facet_ids).add(o.source_vertex).add(o.source_face).add(o.category);
  }
  return digest.value();
}

unsigned long long unite_contacts(const BooleanOptions& options) {
  return digest_of(evaluate_boolean(Operation::Union, pointers_to(operands.touching), options));
}

unsigned long long partition_contacts(const BooleanOptions& options) {
  return digest_of(evaluate_boolean(Operation::Partition, pointers_to(operands.touching), options));
}

unsigned long long implant_contacts(const BooleanOptions& options) {
  return digest_of(implant(pointers_to(operands.touching), ImplantContact::Keep, options));
}

unsigned long long imprint_contacts(const BooleanOptions& options) { return digest_of(imprint(pointers_to(operands.touching), options)); }

unsigned long long keep_some_faces(const BooleanOptions& options) {
  const std::vector<std::string> tags{"10", "20", "same"};
  return digest_of(keep_faces(keep_mask(tags), pointers_to(operands.touching), options));
}

unsigned long long combine_contacts(const BooleanOptions& options) {
  return digest_of(evaluate_expression("(a | b) - c", pointers_to(operands.touching), options));
}

unsigned long long resolve_overlap(const BooleanOptions& options) { return digest_of(resolve(operands.touching[0], options)); }

unsigned long long unite_crossing(const BooleanOptions& options) {
  const BooleanResult result = evaluate_boolean(Operation::Union, pointers_to(operands.crossing), options);
  MORTISE_CHECK(!result.report.self_contacts.empty(), "the star: it is here to be arranged a second time");
  return digest_of(result);
}

unsigned long long subtract_far_apart(const BooleanOptions& options) {
  return digest_of(evaluate_boolean(Operation::Subtract, pointers_to(operands.slanted), options));
}

unsigned long long cut_by_half_space(const BooleanOptions& options) {
  const SurfaceMesh half_space = make_half_space({{1, 2, 3}, 3}, bounding_box(operands.slanted[0]));
  const std::vector<const SurfaceMesh*> both{&operands.slanted[0], &half_space};
  BooleanOptions with_half_space = options;
  with_half_space.half_spaces = {1};
  return digest_of(evaluate_boolean(Operation::Intersect, both, with_half_space));
}

/// The error is the result.
unsigned long long refuse_inside_out(const BooleanOptions& options) {
  try {
    (void)evaluate_boolean(Operation::Union, pointers_to(operands.refused), options);
  } catch (const Error& error) {
    if (error.code == ErrorCode::Cancelled) throw;
    return Digest().add(error.code).add(error.message).add(error.ids).add(error.operand).value();
  }
  fail_check("an error", __FILE__, __LINE__, "operands to be refused");
}

unsigned long long partition_slivers(const BooleanOptions& options) {
  const BooleanResult result = evaluate_boolean(Operation::Partition, pointers_to(operands.slivers), options);
  MORTISE_CHECK(result.report.certificate.repair_displacement > 0, "the slivers: they are here to be repaired");
  return digest_of(result);
}

/// Prepared, then moved: an operand that crosses itself, and one of parts that overlap.
unsigned long long unite_prepared(const BooleanOptions& options) {
  const PreparedOperand star(operands.crossing[0]), parts(operands.touching[0]);
  const AffineMap place = compose(rotation(Axis::X, 30), translation({-1, -1, 0.5}));
  return digest_of(evaluate_boolean(Operation::Union, std::array{Operand(star), Operand(parts, place)}, options));
}

std::vector<Call> boolean_calls() {
  return {
      {"unite, contacts and a sheet", unite_contacts},
      {"partition, contacts and a sheet", partition_contacts},
      {"implant, contacts and a sheet", implant_contacts},
      {"imprint, contacts and a sheet", imprint_contacts},
      {"keep_faces, contacts and a sheet", keep_some_faces},
      {"evaluate_expression, contacts and a sheet", combine_contacts},
      {"resolve, parts that overlap", resolve_overlap},
      {"unite, one part that crosses itself", unite_crossing},
      {"subtract, coordinates far apart", subtract_far_apart},
      {"intersect with a half-space", cut_by_half_space},
      {"partition, repaired slivers", partition_slivers},
      {"unite, refused", refuse_inside_out},
      {"prepare, move and unite", unite_prepared},
  };
}

unsigned long long repair_faulty() {
  const RepairedMesh repaired = repair(operands.faulty[0], {true, true, true, true, true, true});
  MORTISE_CHECK(repaired.done.size() >= 5, "the box with faults: they are here to be mended");
  Digest digest;
  digest.add(repaired.mesh).add(repaired.source_face).add(repaired.source_vertex);
  for (const RepairNote& note : repaired.done) digest.add(note.step).add(note.outcome).add(note.count).add(note.faces);
  return digest.value();
}

unsigned long long slice_overlap() {
  const Section section = slice(operands.touching[0], {{0.25, 0.5, 1}, 1.5});
  return Digest().add(section.polygons).add(section.areas).add(section.area).value();
}

unsigned long long inspect_and_split() {
  const SurfaceMesh& mesh = operands.touching[0];
  const MeshReport report = inspect(mesh);
  return Digest().add(split_parts(mesh, SplitBy::Components)).add(split_parts(mesh, SplitBy::Regions)).add(report.crossing_pairs).value();
}

unsigned long long extrude_hill() { return Digest().add(extrude_to(operands.hill, 0)).value(); }

unsigned long long write_and_read(Format format) {
  const std::string bytes = write_mesh(operands.touching[0], format);
  return Digest().add(bytes).add(read_mesh(bytes, "mesh." + std::string(format_name(format)))).value();
}

/// Calls that report no progress.
std::vector<Call> mesh_calls() {
  using Options = const BooleanOptions&;
  return {
      {"repair, all steps", [](Options) { return repair_faulty(); }},
      {"slice", [](Options) { return slice_overlap(); }},
      {"inspect and split_parts", [](Options) { return inspect_and_split(); }},
      {"extrude_to", [](Options) { return extrude_hill(); }},
      {"write and read OBJ", [](Options) { return write_and_read(Format::Obj); }},
      {"write and read OFF", [](Options) { return write_and_read(Format::Off); }},
      {"write and read PLY", [](Options) { return write_and_read(Format::PlyAscii); }},
      {"write and read STL", [](Options) { return write_and_read(Format::StlAscii); }},
      {"write and read MSH 4.1", [](Options) { return write_and_read(Format::Msh41); }},
      {"write and read MSH 2.2", [](Options) { return write_and_read(Format::Msh22); }},
      {"write and read VTK", [](Options) { return write_and_read(Format::Vtk); }},
      {"write and read VTU", [](Options) { return write_and_read(Format::Vtu); }},
      {"write and read MEDIT", [](Options) { return write_and_read(Format::Medit); }},
      {"write GLB", [](Options) { return Digest().add(write_mesh(operands.touching[0], Format::Glb)).value(); }},
  };
}

// ---- failing

enum class End { Result, OutOfMemory, Cancelled, Other };

/// How a call ended, and what it did until then.
struct Outcome {
  End end = End::Result;
  unsigned long long digest = 0;
  unsigned long long allocations = 0;
  unsigned long long reports = 0;
  bool was_told = false;  ///< see Memory
};

End end_of(const Error& error) { return error.code == ErrorCode::Cancelled ? End::Cancelled : End::Other; }

/// Makes the call; the allocation or the report of that number fails.
Outcome attempt(const Call& call, Failure failure, unsigned long long number) {
  Outcome outcome;
  const unsigned long long stop = failure == Failure::Cancellation ? number : 0;
  BooleanOptions options;
  options.progress = [&outcome, stop](std::string_view, double) { return ++outcome.reports != stop; };
  memory.arm(failure == Failure::Cancellation ? 0 : number, failure == Failure::AllLaterAllocations);
  try {
    outcome.digest = call.run(options);
  } catch (const std::bad_alloc&) {
    outcome.end = End::OutOfMemory;
  } catch (const Error& error) {
    outcome.end = end_of(error);
  } catch (...) {
    outcome.end = End::Other;
  }
  outcome.allocations = memory.made;
  outcome.was_told = memory.was_told;
  memory.arm(0, false);
  return outcome;
}

/// What is wrong with the call after that failure; empty when nothing is.
const char* fault_of(const Call& call, const Outcome& plain, Failure failure, unsigned long long number) {
  const long long live = memory.live;
  const Outcome outcome = attempt(call, failure, number);
  if (memory.live != live) return "memory is not freed";
  if (outcome.end == End::Result && outcome.was_told) return outcome.digest == plain.digest ? "" : "a wrong result";
  if (outcome.end == End::Result) return "the failure was swallowed";
  return outcome.end == (failure == Failure::Cancellation ? End::Cancelled : End::OutOfMemory) ? "" : "another error";
}

const char* name_of(Failure failure) {
  if (failure == Failure::Cancellation) return "cancelled";
  return failure == Failure::OneAllocation ? "one allocation fails" : "all later allocations fail";
}

/// Do all failures of this kind leave the call, its operands and the memory as they were?
bool check(const Call& call, Failure failure, unsigned long long most_tries) {
  running = call.name;
  const Outcome plain = attempt(call, Failure::None, 0);
  const unsigned long long before = operands.digest();
  const unsigned long long places = failure == Failure::Cancellation ? plain.reports : plain.allocations;
  const unsigned long long tries = most_tries == 0 ? places : std::min(places, most_tries);
  unsigned long long failed = tries == 0 ? 1 : 0;
  for (unsigned long long i = 0; i < tries; ++i) {
    const unsigned long long number = 1 + i * places / tries;
    const char* fault = fault_of(call, plain, failure, number);
    if (*fault == '\0' && operands.digest() != before) fault = "an operand was changed";
    if (*fault == '\0') continue;
    ++failed;
    std::printf("FAILED: %s, %s, number %llu: %s\n", call.name, name_of(failure), number, fault);
  }
  const Outcome again = attempt(call, Failure::None, 0);
  const bool is_same =
      plain.end == End::Result && again.end == End::Result && again.digest == plain.digest && again.allocations == plain.allocations;
  std::printf("%s, %s: %llu tries at %llu places, %llu failed%s\n", call.name, name_of(failure), tries, places, failed,
              is_same ? "" : ", FAILED: not the same result before and afterwards");
  return failed == 0 && is_same;
}

[[noreturn]] void say_where() {
  std::fprintf(stderr, "FAILED: %s, allocation %llu: the program was ended\n", running, memory.failing);
  std::_Exit(1);
}

struct Tally {
  std::size_t cases = 0, failed = 0;

  void add(bool is_passed) {
    ++cases;
    failed += is_passed ? 0 : 1;
  }
};

Tally check_all(unsigned long long most_tries) {
  Tally tally;
  for (const Failure failure : {Failure::OneAllocation, Failure::AllLaterAllocations}) {
    for (const Call& call : boolean_calls()) tally.add(check(call, failure, most_tries));
    for (const Call& call : mesh_calls()) tally.add(check(call, failure, most_tries));
  }
  for (const Call& call : boolean_calls()) tally.add(check(call, Failure::Cancellation, 0));
  return tally;
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  char* end = nullptr;
  const unsigned long long most_tries = argc == 3 ? std::strtoull(argv[2], &end, 10) : 1000;
  if (argc != 1 && (argc != 3 || std::strcmp(argv[1], "--tries") != 0 || end == argv[2] || *end != '\0')) {
    std::fputs("usage: failed_calls [--tries N]\n", stderr);
    return 2;
  }
  std::set_terminate(say_where);
  const Tally tally = check_all(most_tries);
  std::printf("test cases: %zu | %zu passed | %zu failed\n", tally.cases, tally.cases - tally.failed, tally.failed);
  return tally.failed == 0 ? 0 : 1;
}
