# Draws copies of a mesh. Their places are kept here: a MultiMesh that is made without a graphics card, as by godot3-server,
# loses them.
tool
extends MultiMeshInstance

# A Transform each.
export var places = []


func _ready():
	multimesh.instance_count = places.size()
	for i in places.size():
		multimesh.set_instance_transform(i, places[i])
