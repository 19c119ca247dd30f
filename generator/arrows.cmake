# The arrows between the folders of the generator, stated once: which others the files of each may
# include. A folder comes after all that it includes. generator/CMakeLists.txt links along the arrows;
# tests/lint/arrows.mjs holds every include and the table of generator/README.md against them.
set(folders base process remote remote/client cache toolchain actions report lesson/syntax lesson/json
    lesson/blocks lesson course findings physics/mistakes physics script evaluate/codec
    evaluate/context evaluate/programs evaluate/scenes evaluate/answers evaluate/claims evaluate
    session page/html page/blocks page preview lsp cli)

set(base_includes)
set(process_includes base)
set(remote_includes process base)
set(remote/client_includes remote base)
set(cache_includes base)
set(toolchain_includes cache process base)
set(actions_includes toolchain cache process base)
set(report_includes process base)
set(lesson/syntax_includes report base)
set(lesson/json_includes lesson/syntax base)
set(lesson/blocks_includes lesson/json lesson/syntax base)
set(lesson_includes lesson/blocks lesson/json lesson/syntax report base)
set(course_includes lesson lesson/blocks lesson/json lesson/syntax report process base)
set(findings_includes course lesson/blocks report base)
set(physics/mistakes_includes base)
set(physics_includes physics/mistakes process base)
set(script_includes physics findings base)
set(evaluate/codec_includes findings lesson cache base)
set(evaluate/context_includes actions toolchain cache script physics findings course lesson/syntax
    report process base)
set(evaluate/programs_includes evaluate/context actions toolchain cache physics findings
    lesson/blocks lesson/syntax report process base)
set(evaluate/scenes_includes evaluate/context script physics findings course lesson lesson/blocks
    lesson/syntax report process base)
set(evaluate/answers_includes evaluate/context script physics findings lesson/blocks lesson/syntax
    base)
set(evaluate/claims_includes evaluate/answers evaluate/context toolchain cache physics findings lesson
    lesson/blocks base)
set(evaluate_includes evaluate/claims evaluate/answers evaluate/scenes evaluate/programs
    evaluate/context evaluate/codec actions toolchain cache script physics findings course lesson
    lesson/blocks report process base)
set(session_includes evaluate course base)
set(page/html_includes findings course lesson/blocks lesson/syntax report base)
set(page/blocks_includes page/html script findings course lesson/blocks report base)
set(page_includes page/blocks page/html script findings course lesson lesson/json lesson/syntax
    report process base)
set(preview_includes page page/blocks page/html session report process base)
set(lsp_includes session evaluate physics course lesson lesson/blocks lesson/json report base)
set(cli_includes lsp preview page page/blocks page/html session evaluate evaluate/claims toolchain
    physics findings course lesson lesson/syntax lesson/json report process remote base)

# What a folder does not reach through headers of others either, of folders and of libraries: data knows
# nothing of those who find it out, and what shows it computes no physics.
# Nor does what is compiled and run depend on what a lesson is, or on how mistakes are told.
set(actions_never mujoco JavaScriptCore)
set(report_never mujoco JavaScriptCore)
set(lesson/syntax_never mujoco JavaScriptCore)
set(lesson/json_never mujoco JavaScriptCore)
set(lesson/blocks_never mujoco JavaScriptCore)
set(lesson_never mujoco JavaScriptCore)
set(course_never mujoco JavaScriptCore)
set(findings_never mujoco JavaScriptCore)
set(page/html_never physics mujoco JavaScriptCore)
set(page/blocks_never physics evaluate mujoco)
set(page_never physics evaluate mujoco)
set(lsp_never page)
