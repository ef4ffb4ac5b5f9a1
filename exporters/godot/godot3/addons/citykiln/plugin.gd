# The plugin for Godot 3: a dock that imports a run of citykiln.
tool
extends EditorPlugin

var dock


func _enter_tree():
	dock = preload("dock.gd").new()
	dock.files = get_editor_interface().get_resource_filesystem()
	add_control_to_dock(DOCK_SLOT_LEFT_UR, dock)


func _exit_tree():
	remove_control_from_docks(dock)
	dock.free()
