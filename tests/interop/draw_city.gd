# Runs inside Godot 3: loads a city that exporters/godot/godot3 made, writes facts about it as JSON, and draws pictures. The
# environment variable JOB names a JSON file: "scene", "facts", "pictures" (out, eye, look, fov_deg, size, hour), "rays"
# (from), "walks" (from, yaw_deg, seconds). Of each picture the engine's own counts of draw calls and vertices are written,
# with the shadows of the sun and without.
extends SceneTree

var job
var city


func _init():
	var file = File.new()
	file.open(OS.get_environment("JOB"), File.READ)
	job = parse_json(file.get_as_text())
	city = load(job["scene"]).instance()
	get_root().add_child(city)
	light_and_camera()
	var facts = {"tiles": {}, "shown": [], "counts": [], "light": [], "hits": [], "walks": []}
	for tile in city.tiles():
		facts["tiles"][tile.name] = {}
		for level in tile.get_children():
			facts["tiles"][tile.name][level.name] = facts_of(level)
	for picture in job["pictures"]:
		yield(draw(picture), "completed")
		facts["shown"].append(shown_levels())
		facts["light"].append(light_now())
		facts["counts"].append(yield(counts_now(), "completed"))
	# shapes of hidden levels would be hit too
	yield(self, "physics_frame")
	for ray in job["rays"]:
		facts["hits"].append(hit_below(ray))
	for walk in job.get("walks", []):
		facts["walks"].append(yield(walked(walk), "completed"))
	file.open(job["facts"], File.WRITE)
	file.store_string(to_json(facts))
	file.close()
	quit()


func below(node):
	var found = [node]
	for child in node.get_children():
		found += below(child)
	return found


func facts_of(level):
	var facts = {"layers": [], "objects": 0, "multis": 0, "copies": 0, "places": 0, "triangles": 0, "shapes": []}
	for layer in level.get_child(0).get_children():
		facts["layers"].append(layer.name)
	for node in below(level):
		if node is MeshInstance:
			facts["objects"] += 1
			facts["triangles"] += triangles_of(node.mesh)
		elif node is MultiMeshInstance:
			facts["multis"] += 1
			facts["copies"] += node.multimesh.instance_count
			facts["places"] += places_of(node.multimesh)
			facts["triangles"] += triangles_of(node.multimesh.mesh) * node.multimesh.instance_count
		elif node is CollisionShape:
			facts["shapes"].append(node.get_parent().get_parent().name)
	return facts


# The number of different places of copies.
func places_of(multimesh):
	var places = {}
	for i in multimesh.instance_count:
		places[multimesh.get_instance_transform(i).origin] = true
	return places.size()


func triangles_of(mesh):
	var count = 0
	for i in mesh.get_surface_count():
		count += mesh.surface_get_array_index_len(i) / 3
	return count


func shown_levels():
	var shown = {}
	for tile in city.tiles():
		for level in tile.get_children():
			if level.visible:
				shown[tile.name] = shown.get(tile.name, []) + [level.name]
	return shown


func hit_below(place):
	var from = Vector3(place[0], place[1], place[2])
	var hit = get_root().world.direct_space_state.intersect_ray(from, from - Vector3(0, 1000, 0))
	if hit.empty():
		return null
	return {"height_m": hit["position"].y, "layer": hit["collider"].get_parent().name}


# What shines now.
func light_now():
	var emission = 0.0
	for material in city.shining:
		emission = max(emission, material.emission_energy)
	var lamps = 0
	for light in city.lights:
		lamps += 1 if light.visible else 0
	return {"sun": city.get_node("Sun").light_energy if city.get_node("Sun").visible else 0.0, "lamps": lamps,
		"emission": emission, "shining": city.shining.size(), "to_sun": list(city.get_node("Sun").transform.basis.z)}


func list(v):
	return [v.x, v.y, v.z]


# The engine's counts of the frame, and what the city says it shows.
func counts_now():
	var sun = city.get_node("Sun")
	var counts = {"calls_shown": city.calls, "triangles_shown": city.triangles}
	for shadows in [true, false]:
		sun.shadow_enabled = shadows
		for i in 2:
			yield(self, "idle_frame")
		var name = "with_shadows" if shadows else "calls"
		counts[name] = VisualServer.get_render_info(VisualServer.INFO_DRAW_CALLS_IN_FRAME)
		counts[name + "_vertices"] = VisualServer.get_render_info(VisualServer.INFO_VERTICES_IN_FRAME)
	sun.shadow_enabled = true
	return counts


# Where someone is after each tenth of a second who walks straight ahead.
func walked(walk):
	var walker = KinematicBody.new()
	walker.set_script(load("res://addons/citykiln/walker.gd"))
	get_root().add_child(walker)
	walker.translation = Vector3(walk["from"][0], walk["from"][1], walk["from"][2])
	walker.rotation_degrees.y = walk["yaw_deg"]
	walker.ahead = 1.0
	var places = []
	for i in int(walk["seconds"] * 60):
		yield(self, "physics_frame")
		if i % 6 == 0:
			places.append(list(walker.translation))
	var ways = ways_of(places, [walker])
	walker.queue_free()
	return {"places": places, "ways": ways}


# What of solid things lies between places in sequence at the height of a chest: nothing, if walls stop a walker.
func ways_of(places, but):
	var met = []
	for i in range(1, places.size()):
		var from = Vector3(places[i - 1][0], places[i - 1][1] + 1.2, places[i - 1][2])
		var to = Vector3(places[i][0], places[i][1] + 1.2, places[i][2])
		var hit = get_root().world.direct_space_state.intersect_ray(from, to, but)
		if not hit.empty():
			met.append(hit["collider"].get_parent().name)
	return met


func light_and_camera():
	var camera = Camera.new()
	camera.name = "camera"
	camera.far = 6000
	camera.near = 0.2
	get_root().add_child(camera)
	camera.make_current()


func draw(picture):
	var size = Vector2(picture["size"][0], picture["size"][1])
	OS.window_size = size
	get_root().size = size
	var camera = get_root().get_node("camera")
	camera.fov = picture["fov_deg"]
	var eye = picture["eye"]
	var look = picture["look"]
	camera.look_at_from_position(Vector3(eye[0], eye[1], eye[2]), Vector3(look[0], look[1], look[2]), Vector3(0, 1, 0))
	if "hour" in picture:
		city.hour = picture["hour"]
	city.choose_levels()
	for i in 4:
		yield(self, "idle_frame")
	var image = get_root().get_texture().get_data()
	image.flip_y()
	image.save_png(picture["out"])
