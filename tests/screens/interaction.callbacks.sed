# The window closes by Enter instead of Escape.
s/key == GLFW_KEY_ESCAPE/key == GLFW_KEY_ENTER/
