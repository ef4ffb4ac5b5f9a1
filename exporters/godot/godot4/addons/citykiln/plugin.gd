# The plugin for Godot 4: a dock that imports a run of citykiln.
@tool
extends EditorPlugin

const Dock = preload("dock.gd")

var dock: Dock


func _enter_tree() -> void:
	dock = Dock.new()
	dock.files = EditorInterface.get_resource_filesystem()
	add_control_to_dock(DOCK_SLOT_LEFT_UR, dock)


func _exit_tree() -> void:
	remove_control_from_docks(dock)
	dock.free()
