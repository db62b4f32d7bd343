# SPDX-FileCopyrightText: the Mortise authors
# SPDX-License-Identifier: MIT
# Target mortise_wasm: wasm/bindings/*.cpp and the library -> glue.mjs and core.wasm, from one link, in MORTISE_WASM_DIST.

# Parts of the library that read a few words, repair a few triangles or run once per result: what they weigh counts, not how
# fast they are.
set(mortise_light_sources
    boolean/certify_or_repair boolean/cut_by_sheets boolean/evaluate_boolean boolean/evaluate_expression boolean/expression
    boolean/facet_sources boolean/given_operands boolean/implant boolean/imprint boolean/imprinted_operand
    boolean/join_coincident boolean/keep_faces boolean/keep_triangles boolean/merge_close_vertices boolean/moved_shells boolean/operation
    boolean/refuse_operands boolean/repair_by_snapping boolean/resolve boolean/result_regions boolean/share_within_tolerance boolean/simplify
    boolean/shared_edges boolean/stacked_triangles boolean/swap_slivers boolean/triangulate_shared_faces
    brep/assemble_brep brep/attributes brep/build_brep brep/divide_mesh brep/lineage brep/model_mesh brep/model_queries brep/named_model brep/rebuild_brep brep/kept_faces brep/result_features brep/face_boundaries brep/seams
    brep/trace_edges brep/validate_brep
    io/abaqus io/cell_grid io/entity_mesh io/entity_mesh_builder io/fitted_number io/formats io/glb io/gmsh_script io/medit io/msh io/msh22 io/msh41
    io/nastran io/obj_data io/off io/ply_data io/ply_header io/vtk io/vtu io/xml
    mesh/corners_to_vertices mesh/drop_faces mesh/extrude_to mesh/fill_planar_holes mesh/find_cells mesh/find_shells mesh/group_by_label mesh/half_space
    mesh/order_round_edge mesh/orient_faces mesh/repair
    mesh/require_closed mesh/select_faces mesh/shape_by_name mesh/shapes mesh/slice mesh/split_parts mesh/split_pinches
    mesh/triangulate_polygon mesh/volume_sign mesh/wedge_partners
    remesh/deviation remesh/free_triangles remesh/improve_worst_triangles remesh/model_edge_chains remesh/new_crossings remesh/quality_report remesh/quality_table remesh/remesh remesh/resample_model_edges
    size/background_view size/curvature_sources size/face_curvature size/graph_sources size/model_sources size/size_source)
list(TRANSFORM mortise_light_sources PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/src/mortise/")
list(TRANSFORM mortise_light_sources APPEND ".cpp")
set_source_files_properties(${mortise_light_sources} PROPERTIES COMPILE_OPTIONS -Oz)

set(MORTISE_WASM_DIST "${CMAKE_CURRENT_SOURCE_DIR}/wasm/dist" CACHE PATH "Where glue.mjs and core.wasm go")
file(GLOB wasm_binding_sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/wasm/bindings/*.cpp")
if(wasm_binding_sources)
  add_executable(mortise_wasm ${wasm_binding_sources})
  set_target_properties(mortise_wasm PROPERTIES OUTPUT_NAME glue SUFFIX .mjs)
  # Bindings copy arrays and name fields: what they weigh counts, not how fast they are.
  target_compile_options(mortise_wasm PRIVATE ${MORTISE_EM_COMPILE_OPTIONS} ${MORTISE_EM_LTO} -Oz)
  target_link_libraries(mortise_wasm PRIVATE mortise mortise_flags)
  target_link_options(mortise_wasm PRIVATE ${MORTISE_EM_PACKAGE_LINK_OPTIONS})
  add_custom_command(
    TARGET mortise_wasm POST_BUILD
    COMMAND "${CMAKE_COMMAND}" -D "glue=$<TARGET_FILE:mortise_wasm>" -D "dist=${MORTISE_WASM_DIST}" -P
            "${CMAKE_CURRENT_SOURCE_DIR}/cmake/copy_wasm_package.cmake"
    VERBATIM)
endif()
