# The arrows between the folders of the generator, stated once: what each may reach by its includes,
# its own and those of the headers that it includes. generator/CMakeLists.txt links along them,
# tests/lint/arrows.mjs holds every include and the table of generator/README.md against them.
set(folders base report lesson course findings physics script evaluate session page preview lsp cli)

set(base_reaches)
set(report_reaches base)
set(lesson_reaches report base)
set(course_reaches lesson report base)
set(findings_reaches course lesson report base)
set(physics_reaches report base)
set(script_reaches findings physics report base)
set(evaluate_reaches script physics findings course lesson report base)
set(session_reaches evaluate script physics findings course lesson report base)
set(page_reaches script findings course lesson report base)
set(preview_reaches page session evaluate script physics findings course lesson report base)
set(lsp_reaches session evaluate script physics findings course lesson report base)
set(cli_reaches lsp preview page session evaluate script physics findings course lesson report base)

# What is data knows neither of those who find it out, and what shows it computes no physics.
set(findings_never mujoco JavaScriptCore)
set(report_never mujoco JavaScriptCore)
set(lesson_never mujoco JavaScriptCore)
set(course_never mujoco JavaScriptCore)
set(page_never mujoco)
