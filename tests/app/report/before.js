// Runs before the page: keeps its errors.
var complaints = [];
window.addEventListener("error", function (event) { complaints.push(String(event.message)); });
console.error = function (text) { complaints.push(String(text)); };
