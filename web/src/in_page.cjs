module.exports = libraries; // what libraries.js has put into the page
