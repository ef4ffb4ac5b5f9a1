# Import script for Godot 3.2, which reads every COLOR_0 of bytes as white: gives leaves the mean of their vertex colours.
tool
extends EditorScenePostImport

const COLOURS = {"BroadLeafCutout": Color(0.40, 0.61, 0.42), "NeedleLeafCutout": Color(0.47, 0.60, 0.55)}


func post_import(scene):
	colour(scene)
	return scene


func colour(node):
	if node is MeshInstance:
		for i in node.mesh.get_surface_count():
			var material = node.mesh.surface_get_material(i)
			var kind = material.resource_name.split("_")[0]
			if kind in COLOURS:
				material.albedo_color = COLOURS[kind]
	for child in node.get_children():
		colour(child)
