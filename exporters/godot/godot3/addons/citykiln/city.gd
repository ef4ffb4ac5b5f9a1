# A city of citykiln's tiles. It has a child for each tile, which has a child for each level, L0 the finest. Of each tile
# the coarsest level is shown whose error on the screen is at most `pixel_error`, from the current camera; coarser ones
# while the budget of draw calls or triangles is exceeded. `hour` sets the sun, the sky, lamps and lit windows.
extends Spatial

# Largest error on the screen, in pixels.
export var pixel_error = 2.0
# What may be drawn in all, without shadows. A small graphics card draws this in 1/60 s.
export var most_calls = 300
export var most_triangles = 3000000
# The largest geometric error of each level in metres, finest first.
export var errors_m = []
# The sources of the data, to be named beside every picture.
export var attribution = ""
# Seconds between two choices of levels.
export var interval_s = 0.25
# Day of the run's time, and the place of its origin.
export var date = "2000-06-21"
export var longitude_deg = 0.0
export var latitude_deg = 0.0
# Hour of that day in UTC.
export var hour = 12.0 setget set_hour
# Lights of the nearest lamps by night; the others glow but light nothing.
export var lamp_lights = 8

const LAMP_COLOUR = Color(1, 0.8, 0.55)

# what is shown: draw calls and triangles of whole tiles, in and out of view
var calls = 0
var triangles = 0
var is_night = false
var waited_s = 0.0
var shining = []
var lights = []
var glow = MultiMeshInstance.new()


func _ready():
	for i in lamp_lights:
		var light = OmniLight.new()
		light.light_color = LAMP_COLOUR
		light.omni_range = 14
		light.light_energy = 1.5
		light.visible = false
		lights.append(light)
		add_child(light)
	glow.multimesh = glow_of(lamp_places())
	add_child(glow)
	shining = shining_materials()
	set_hour(hour)
	choose_levels()


func _process(delta):
	waited_s += delta
	if waited_s >= interval_s:
		waited_s = 0.0
		choose_levels()


# ---- levels ----

func tiles():
	var found = []
	for child in get_children():
		if not (child is Light or child is WorldEnvironment or child == glow):
			found.append(child)
	return found


func choose_levels():
	var camera = get_viewport().get_camera()
	if camera == null:
		return
	var pixels = pixel_error
	var chosen = levels_within(pixels, camera)
	while (calls > most_calls or triangles > most_triangles) and pixels < 1000:
		pixels *= 1.25
		chosen = levels_within(pixels, camera)
	for tile in chosen:
		for level in tile.get_children():
			level.visible = level == chosen[tile]
	if is_night:
		place_lights(camera.global_transform.origin)


# Tile -> the level that is wanted there for an error in pixels. Sets calls and triangles.
func levels_within(pixels, camera):
	calls = 0
	triangles = 0
	var chosen = {}
	for tile in tiles():
		var level = level_at(distance_m(tile, camera.global_transform.origin), metres_to_pixels(camera), pixels)
		chosen[tile] = tile.get_child(min(level, tile.get_child_count() - 1))
		calls += chosen[tile].get_meta("calls")
		triangles += chosen[tile].get_meta("triangles")
	return chosen


# Pixels that one metre takes on the screen at a distance of one metre.
func metres_to_pixels(camera):
	return get_viewport().size.y / (2.0 * tan(deg2rad(camera.fov) / 2.0))


# The coarsest level that is fine enough at a distance; the finest if none is.
func level_at(distance, scale, pixels):
	for level in range(errors_m.size() - 1, 0, -1):
		if errors_m[level] * scale <= pixels * distance:
			return level
	return 0


# The distance from a place to a tile's box; 0 inside.
func distance_m(tile, place):
	var box = tile.get_child(0).get_meta("box")
	var local = tile.get_child(0).to_local(place)
	var nearest = Vector3(clamp(local.x, box.position.x, box.end.x), clamp(local.y, box.position.y, box.end.y),
		clamp(local.z, box.position.z, box.end.z))
	return local.distance_to(nearest)


# ---- day and night ----

func set_hour(value):
	hour = value
	if not is_inside_tree():
		return
	var to_sun = sun_at(date, hour, longitude_deg, latitude_deg)
	var day = clamp((to_sun.y + 0.1) / 0.3, 0.0, 1.0)
	is_night = to_sun.y < -0.05
	$Sun.visible = to_sun.y > 0.0
	if $Sun.visible:
		$Sun.transform = Transform().looking_at(-to_sun, Vector3.UP)
	$Sun.light_energy = 2.5 * clamp(to_sun.y / 0.2, 0.0, 1.0)
	$Sun.light_color = Color(1, 0.93, 0.83).linear_interpolate(Color(1, 0.6, 0.35), 1.0 - clamp(to_sun.y / 0.3, 0.0, 1.0))
	show_sky($Sky.environment, day)
	for material in shining:
		material.emission_energy = 2.0 if is_night else 0.0
	for light in lights:
		light.visible = false
	glow.visible = is_night
	choose_levels()


# The sky at a share of daylight, 0 by night. By day it is as bright as in citykiln's preview; by night as eyes that are used
# to it see it.
func show_sky(environment, day):
	var sky = environment.background_sky
	sky.sky_top_color = Color(0.03, 0.04, 0.09).linear_interpolate(Color(0.42, 0.54, 0.73), day)
	sky.sky_horizon_color = Color(0.1, 0.11, 0.17).linear_interpolate(Color(0.67, 0.76, 0.85), day)
	sky.ground_bottom_color = Color(0.04, 0.04, 0.05).linear_interpolate(Color(0.42, 0.4, 0.38), day)
	sky.ground_horizon_color = Color(0.08, 0.09, 0.12).linear_interpolate(Color(0.6, 0.66, 0.7), day)
	environment.ambient_light_color = Color(0.4, 0.45, 0.65)
	environment.ambient_light_sky_contribution = day
	environment.ambient_light_energy = 0.12 + 0.88 * day


# The direction to the sun, y up, by the formula of low precision of the Astronomical Almanac: within 0.1 degrees.
static func sun_at(day, hour_utc, longitude, latitude):
	var words = day.split("-")
	var midnight = OS.get_unix_time_from_datetime({"year": int(words[0]), "month": int(words[1]), "day": int(words[2]),
		"hour": 0, "minute": 0, "second": 0})
	# days since 2000-01-01 12:00
	var n = (midnight - 946728000) / 86400.0 + hour_utc / 24.0
	var mean = deg2rad(357.528 + 0.9856003 * n)
	var along = deg2rad(280.46 + 0.9856474 * n + 1.915 * sin(mean) + 0.02 * sin(2.0 * mean))
	var tilt = deg2rad(23.439)
	var declination = asin(sin(tilt) * sin(along))
	var turn = deg2rad(fmod(280.46061837 + 360.98564736629 * n + longitude, 360.0)) - atan2(cos(tilt) * sin(along), cos(along))
	var lat = deg2rad(latitude)
	return Vector3(-cos(declination) * sin(turn), sin(lat) * sin(declination) + cos(lat) * cos(declination) * cos(turn),
		-(cos(lat) * sin(declination) - sin(lat) * cos(declination) * cos(turn)))


# All materials of the tiles that shine: lit windows, the glass of lamps.
func shining_materials():
	var found = {}
	var nodes = tiles()
	while not nodes.empty():
		var node = nodes.pop_back()
		nodes += node.get_children()
		var mesh = node.mesh if node is MeshInstance else node.multimesh.mesh if node is MultiMeshInstance else null
		for i in mesh.get_surface_count() if mesh else 0:
			var material = mesh.surface_get_material(i)
			if material.emission_enabled:
				found[material] = true
	return found.keys()


# The places of all lamps: those of the finest levels, since coarse ones have none.
func lamp_places():
	var places = []
	for tile in tiles():
		for lamp in tile.get_child(0).get_meta("lamps"):
			places.append((tile.transform * tile.get_child(0).transform).xform(lamp) - Vector3(0, 0.3, 0))
	return places


# A bright ball at each place, all in one call.
func glow_of(places):
	var multi = MultiMesh.new()
	multi.transform_format = MultiMesh.TRANSFORM_3D
	multi.mesh = SphereMesh.new()
	multi.mesh.radius = 0.18
	multi.mesh.height = 0.36
	multi.mesh.radial_segments = 8
	multi.mesh.rings = 4
	multi.mesh.material = SpatialMaterial.new()
	multi.mesh.material.flags_unshaded = true
	multi.mesh.material.albedo_color = LAMP_COLOUR
	multi.instance_count = places.size()
	for i in places.size():
		multi.set_instance_transform(i, Transform(Basis(), places[i]))
	return multi


# Puts the lights to the lamps nearest to a place.
func place_lights(place):
	var nearest = []
	for i in glow.multimesh.instance_count:
		var at = glow.multimesh.get_instance_transform(i).origin
		nearest.append([at.distance_squared_to(to_local(place)), at])
	nearest.sort_custom(self, "is_nearer")
	for i in lights.size():
		lights[i].visible = i < nearest.size()
		if lights[i].visible:
			lights[i].translation = nearest[i][1]


static func is_nearer(a, b):
	return a[0] < b[0]
