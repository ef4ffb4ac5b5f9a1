# A city of citykiln's tiles. It has a child for each tile, which has a child for each level, L0 the finest. Of each tile
# the coarsest level is shown whose error on the screen is at most `pixel_error`, from the current camera.
extends Spatial

# Largest error on the screen, in pixels.
export var pixel_error = 2.0
# The largest geometric error of each level in metres, finest first.
export var errors_m = []
# The sources of the data, to be named beside every picture.
export var attribution = ""
# Seconds between two choices of levels.
export var interval_s = 0.25

var waited_s = 0.0


func _ready():
	choose_levels()


func _process(delta):
	waited_s += delta
	if waited_s >= interval_s:
		waited_s = 0.0
		choose_levels()


func choose_levels():
	var camera = get_viewport().get_camera()
	if camera == null:
		return
	for tile in get_children():
		if tile is Light or tile is WorldEnvironment:
			continue
		var level = level_at(distance_m(tile, camera.global_transform.origin), metres_to_pixels(camera))
		for i in tile.get_child_count():
			tile.get_child(i).visible = i == min(level, tile.get_child_count() - 1)


# Pixels that one metre takes on the screen at a distance of one metre.
func metres_to_pixels(camera):
	return get_viewport().size.y / (2.0 * tan(deg2rad(camera.fov) / 2.0))


# The coarsest level that is fine enough at a distance; the finest if none is.
func level_at(distance, scale):
	for level in range(errors_m.size() - 1, 0, -1):
		if errors_m[level] * scale <= pixel_error * distance:
			return level
	return 0


# The distance from a place to a tile's box; 0 inside.
func distance_m(tile, place):
	var box = tile.get_child(0).get_meta("box")
	var local = tile.get_child(0).to_local(place)
	var nearest = Vector3(clamp(local.x, box.position.x, box.end.x), clamp(local.y, box.position.y, box.end.y),
		clamp(local.z, box.position.z, box.end.z))
	return local.distance_to(nearest)
