// Before the page: what it complains of is kept.
var complaints = [];
window.addEventListener("error", function (event) { complaints.push(String(event.message)); });
console.error = function (text) { complaints.push(String(text)); };
