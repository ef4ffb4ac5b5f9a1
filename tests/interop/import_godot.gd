# Runs inside Godot 3: loads imported .glb files, writes facts about them as JSON, and draws pictures. The form of a job is in readers.py;
# the environment variable JOB names it.
extends SceneTree

var job
var roots = []
var originals = {}


func _init():
	job = read_json(OS.get_environment("JOB"))
	var facts = []
	for path in job["files"]:
		var scene = load(path).instance()
		get_root().add_child(scene)
		roots.append(scene)
		facts.append(facts_of(scene))
	if job["pictures"].size() > 0:
		prepare()
		for picture in job["pictures"]:
			yield(draw(picture), "completed")
	var file = File.new()
	file.open(job["facts"], File.WRITE)
	file.store_string(to_json(facts))
	file.close()
	quit()


func read_json(path):
	var file = File.new()
	file.open(path, File.READ)
	return parse_json(file.get_as_text())


func meshes_below(node):
	var found = [node] if node is MeshInstance else []
	for child in node.get_children():
		found += meshes_below(child)
	return found


func rows_of(t):
	return [[t.basis.x.x, t.basis.y.x, t.basis.z.x, t.origin.x], [t.basis.x.y, t.basis.y.y, t.basis.z.y, t.origin.y],
		[t.basis.x.z, t.basis.y.z, t.basis.z.z, t.origin.z], [0, 0, 0, 1]]


func list(v):
	return [v.x, v.y, v.z]


func facts_of(scene):
	var facts = {"meshes": {}, "places": {}, "materials": [], "values": {}, "pictures": {}}
	for thing in meshes_below(scene):
		var name = thing.mesh.resource_name
		if not name in facts["meshes"]:
			facts["meshes"][name] = mesh_facts(thing.mesh)
			facts["places"][name] = []
			for i in thing.mesh.get_surface_count():
				var material = thing.mesh.surface_get_material(i)
				if not material.resource_name in facts["materials"]:
					facts["materials"].append(material.resource_name)
					facts["values"][material.resource_name] = material_facts(material)
					if material.albedo_texture:
						var size = material.albedo_texture.get_size()
						facts["pictures"][material.resource_name] = [size.x, size.y]
		facts["places"][name].append(rows_of(thing.global_transform))
	return facts


func material_facts(material):
	return {"scissor": material.params_use_alpha_scissor, "threshold": material.params_alpha_scissor_threshold,
		"cull": material.params_cull_mode, "uv_scale": list(material.uv1_scale)}


func mesh_facts(mesh):
	var triangles = {}
	for i in mesh.get_surface_count():
		var material = mesh.surface_get_material(i).resource_name
		var count = mesh.surface_get_array_index_len(i) / 3
		triangles[material] = triangles.get(material, 0) + count
	var box = mesh.get_aabb()
	return {"triangles": triangles, "low": list(box.position), "high": list(box.end)}


func prepare():
	var camera = Camera.new()
	camera.name = "camera"
	camera.far = 6000
	camera.near = 1
	get_root().add_child(camera)
	camera.make_current()
	var sun = DirectionalLight.new()
	var from = Vector3(job["sun"][0], job["sun"][1], job["sun"][2])
	get_root().add_child(sun)
	sun.look_at_from_position(from, Vector3(0, 0, 0), Vector3(0, 1, 0))
	sun.light_energy = 1.6
	camera.environment = Environment.new()
	camera.environment.background_mode = Environment.BG_COLOR
	camera.environment.ambient_light_energy = 0.6


# A layer is a child of a file's root node. A scene of Godot has a node of its own above the root.
func show_only(names):
	for scene in roots:
		for tile in scene.get_children():
			for layer in tile.get_children():
				layer.visible = names == null or layer.name in names


func white(original, mipmaps):
	var material = original.duplicate()
	if material.albedo_texture and not mipmaps:
		material.albedo_texture = material.albedo_texture.duplicate()
		material.albedo_texture.flags = Texture.FLAG_FILTER
	material.flags_unshaded = true
	material.albedo_color = Color(1000, 1000, 1000, 1)
	return material


func set_white(is_white, mipmaps):
	originals = {}
	for scene in roots:
		for thing in meshes_below(scene):
			for i in thing.mesh.get_surface_count():
				var original = thing.mesh.surface_get_material(i)
				if is_white and not original in originals:
					originals[original] = white(original, mipmaps)
				thing.set_surface_material(i, originals[original] if is_white else null)


func draw(picture):
	show_only(picture["shown"])
	set_white(picture["coverage"], picture["mipmaps"])
	var size = Vector2(picture["size"][0], picture["size"][1])
	OS.window_size = size
	get_root().size = size
	var camera = get_root().get_node("camera")
	camera.fov = picture["fov_deg"]
	camera.environment.background_color = Color(0, 0, 0) if picture["coverage"] else Color(0.72, 0.75, 0.8)
	camera.environment.ambient_light_color = Color(0.75, 0.8, 0.9)
	var eye = Vector3(picture["eye"][0], picture["eye"][1], picture["eye"][2])
	camera.look_at_from_position(eye, Vector3(picture["look"][0], picture["look"][1], picture["look"][2]), Vector3(0, 1, 0))
	for i in 4:
		yield(self, "idle_frame")
	var image = get_root().get_texture().get_data()
	image.flip_y()
	image.save_png(picture["out"])
